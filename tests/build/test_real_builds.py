"""Real packages, built by the real colcon: what works, and what is said when it does not."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from course.build import BuildFailure, BuildOutcome, Store, Workspace, build
from course.errors import MissingHere
from course.rosenv import Ros, node_environment
from tests.build.conftest import HOME, SRC, WORKSPACE
from tests.build.packages import edit, make_package

pytestmark = pytest.mark.slow

Built = Callable[..., BuildOutcome]
Break = Callable[[Path], object]


@pytest.fixture(scope="session")
def kept(shared_builds: Store) -> Store:
    """One store for all of these tests, because an interface package takes ten seconds."""
    return Store(shared_builds.root.parent / "store")


@pytest.fixture
def store(kept: Store) -> Store:
    return kept


@pytest.fixture(scope="session")
def interfaces(kept: Store, ros: Ros) -> BuildOutcome:
    return build(Workspace.scan(HOME / WORKSPACE), ["small_interfaces"], ros, kept)


# ------------------------------------------------------------------------------------- what works


def test_an_interface_package_can_be_used(interfaces: BuildOutcome, ros: Ros) -> None:
    assert interfaces.failure is None
    use = "from small_interfaces.msg import Landmark; print(Landmark(id=3, name='x').name)"
    done = subprocess.run(
        [ros.python, "-c", use],
        env=node_environment(ros, interfaces.prefixes),
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.stdout, done.stderr) == ("x\n", "")


def test_an_executable_runs_from_the_store(built: Built, ros: Ros) -> None:
    outcome = built("small_node")
    assert outcome.failure is None
    script = outcome.prefixes[0] / "lib/small_node/small_talker"
    assert script.read_text().startswith(f"#!{ros.python}\n")
    env = node_environment(ros, outcome.prefixes)
    done = subprocess.run([script], env=env, capture_output=True, text=True, check=True)
    assert done.stdout == "talker here\n"
    # Everything is compiled, so nobody needs to write into the store when it runs.
    assert list(outcome.prefixes[0].rglob("talker.*.pyc"))


def test_colcon_is_content_with_what_only_running_shows(built: Built, src: Path) -> None:
    package = src / "small_node"
    (package / "setup.cfg").unlink()
    edit(package / "small_node/talker.py", "main():", "main()")
    edit(package / "setup.py", "listener:main", "listener.main")
    edit(package / "package.xml", "<depend>", "<depend>exists_nowhere</depend><depend>")
    outcome = built("small_node")
    assert outcome.failure is None
    assert (outcome.prefixes[0] / "bin/small_talker").exists()
    assert not (outcome.prefixes[0] / "lib/small_node").exists()


def test_what_is_built_on_another_package_sees_it(built: Built, src: Path, interfaces: BuildOutcome) -> None:
    using_interfaces(src, "<depend>small_interfaces</depend>")
    outcome = built("user")
    assert outcome.failure is None
    assert [(package.name, package.cached) for package in outcome.packages] == [
        ("small_interfaces", True),
        ("user", False),
    ]


# --------------------------------------------------------------------------- Python packages that do not


def replace(file: str, old: str, new: str) -> Break:
    return lambda package: edit(package / file, old, new)


def remove(file: str) -> Break:
    return lambda package: (package / file).unlink()


def rename(file: str, name: str) -> Break:
    return lambda package: (package / file).rename((package / file).with_name(name))


ENTRY = '"small_talker = small_node.talker:main",'

# The change of the package; the kind; places; words of the summary; words of the advice.
PYTHON: dict[str, tuple[Break, str, str, str, str]] = {
    "setup.py is not Python": (
        replace("setup.py", 'version="0.1.0",', 'version="0.1.0,'),
        "setup-py", "setup.py:7", "a quote is missing", "quote",
    ),
    "comma between entry points": (
        replace("setup.py", ENTRY, ENTRY.rstrip(",")),
        "entry-point", "setup.py:21",
        "A comma is missing in setup.py of `small_node`, after the entry point on line 21", "lines 21 and 22",
    ),
    "an entry point without =": (
        replace("setup.py", "small_talker = ", "small_talker "),
        "entry-point", "setup.py:21",
        "Line 21 of setup.py of `small_node` is not an entry point", "function",
    ),
    "marker": (
        remove("resource/small_node"),
        "marker-missing", "resource/small_node setup.py:10", "resource/small_node is missing",
        "`touch resource/small_node`",
    ),
    "names differ": (
        replace("setup.py", 'package_name = "small_node"', 'package_name = "smal_node"'),
        "names-differ", "setup.py:3 package.xml:3", "setup.py calls the package `smal_node`", "same name",
    ),
    "data file": (
        replace("setup.py", '["package.xml"]),', '["package.xml", "launch/small_launch.py"]),'),
        "data-file", "setup.py:11", "installs launch/small_launch.py, but", "data_files",
    ),
    "build type": (
        replace("package.xml", "ament_python", "ament_pyton"),
        "build-type", "package.xml:12", "the build type ament_pyton, which does not exist", "ament_python",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", PYTHON)
def test_the_cause_of_a_failed_python_package_is_named(built: Built, src: Path, name: str) -> None:
    harm, *expected = PYTHON[name]
    harm(src / "small_node")
    check(built("small_node").failure, f"{SRC}/small_node", *expected)


# ------------------------------------------------------------------------ interface packages that do not

CMAKE: dict[str, tuple[Break, str, str, str, str]] = {
    "listed but absent": (
        rename("msg/Landmark.msg", "Landmarks.msg"),
        "interface-missing", "CMakeLists.txt:9", "lists msg/Landmark.msg, but there is no such file",
        "Did you mean `msg/Landmarks.msg`?",
    ),
    "file name in snake_case": (
        lambda package: (rename("msg/Landmark.msg", "land_mark.msg")(package),
                         replace("CMakeLists.txt", "Landmark.msg", "land_mark.msg")(package)),
        "interface-name", "msg/land_mark.msg CMakeLists.txt:9", "An interface cannot be called `land_mark`",
        "Rename the file to `LandMark.msg`",
    ),
    "field in CamelCase": (
        replace("msg/Landmark.msg", "string name", "string landmarkName"),
        "field-name", "msg/Landmark.msg:2", "A field cannot be called `landmarkName`", "`landmark_name`",
    ),
    "unknown basic type": (
        replace("msg/Landmark.msg", "string name", "strin name"),
        "field-type", "msg/Landmark.msg:2", "There is no type `strin`", "Did you mean `string`?",
    ),
    "geometry_msgs not in DEPENDENCIES": (
        replace("CMakeLists.txt", "  DEPENDENCIES geometry_msgs\n", ""),
        "dependencies", "CMakeLists.txt:8 msg/Landmark.msg:3",
        "does not name `geometry_msgs` in DEPENDENCIES", "`DEPENDENCIES geometry_msgs`",
    ),
    "find_package missing": (
        replace("CMakeLists.txt", "find_package(geometry_msgs REQUIRED)\n", ""),
        "find-package-missing", "CMakeLists.txt:7",
        "names `geometry_msgs` in DEPENDENCIES, but has no", "`find_package(geometry_msgs REQUIRED)`",
    ),
    "member_of_group missing": (
        replace("package.xml", "<member_of_group>rosidl_interface_packages</member_of_group>", ""),
        "member-of-group", "package.xml:12", "does not say that the package contains interfaces",
        "`<member_of_group>rosidl_interface_packages</member_of_group>`",
    ),
    "CMake syntax": (
        replace("CMakeLists.txt", "geometry_msgs\n)", "geometry_msgs\n"),
        "cmake-syntax", "CMakeLists.txt:8", "A closing parenthesis is missing in CMakeLists.txt", "line 8",
    ),
    "unknown command": (
        replace("CMakeLists.txt", "rosidl_generate_interfaces", "rosidl_generate_interface"),
        "cmake-command", "CMakeLists.txt:8",
        "calls `rosidl_generate_interface`, which is not a CMake command", "`rosidl_generate_interfaces`?",
    ),
    "package that exists nowhere": (
        lambda package: (replace("package.xml", "geometry_msgs", "geometry_msg")(package),
                         replace("CMakeLists.txt", "geometry_msgs REQ", "geometry_msg REQ")(package)),
        "dependency-missing", "CMakeLists.txt:6", "looks for `geometry_msg`, which does not exist here",
        "Did you mean `geometry_msgs`?",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", CMAKE)
def test_the_cause_of_a_failed_interface_package_is_named(built: Built, src: Path, name: str) -> None:
    harm, *expected = CMAKE[name]
    harm(src / "small_interfaces")
    check(built("small_interfaces").failure, f"{SRC}/small_interfaces", *expected)


# ------------------------------------------------------------------------------- other CMake packages


def using_interfaces(src: Path, depend: str, last: str = "ament_package()") -> Path:
    package = make_package(src, "user")
    edit(package / "package.xml", "ament_python", "ament_cmake")
    edit(package / "package.xml", "<export>", f"\n{depend}\n<export>")
    (package / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.8)\nproject(user)\nfind_package(ament_cmake REQUIRED)\n"
        f"find_package(small_interfaces REQUIRED)\n{last}\n"
    )
    return package


def test_a_workspace_package_that_is_not_declared_is_not_offered(
    built: Built, src: Path, interfaces: BuildOutcome
) -> None:
    using_interfaces(src, "<depend>geometry_msgs</depend>")
    check(
        built("small_interfaces", "user").failure,
        f"{SRC}/user",
        "dependency-undeclared",
        "package.xml:2 CMakeLists.txt:4",
        "`user` uses `small_interfaces`, but its package.xml does not say so",
        "Add `<depend>small_interfaces</depend>` to package.xml",
    )


def test_a_package_that_ros_would_not_find_has_failed(
    built: Built, src: Path, interfaces: BuildOutcome
) -> None:
    using_interfaces(
        src, "<depend>small_interfaces</depend>", "install(FILES package.xml DESTINATION share/user)"
    )
    check(
        built("user").failure,
        f"{SRC}/user",
        "ament-package",
        "CMakeLists.txt",
        "never calls `ament_package()`",
        "last line",
    )


@pytest.mark.parametrize(
    ("program", "kind", "summary", "advice", "place"),
    [
        ("int main() { return 0 }", "compiler", "main.cpp does not compile: exp", "semicolon", "main.cpp:1"),
        (
            "#include <doors/doors.hpp>",
            "compiler",
            "No such file or directory",
            "name right",
            "main.cpp:1",
        ),
        (
            "void f(); int main() { f(); }",
            "linker",
            "`f()` is used, but nothing",
            "listed",
            "CMakeLists.txt:3",
        ),
    ],
)
def test_compiler_and_linker_are_quoted(
    built: Built, src: Path, program: str, kind: str, summary: str, advice: str, place: str
) -> None:
    package = make_package(src, "program")
    edit(package / "package.xml", "ament_python", "ament_cmake")
    (package / "main.cpp").write_text(program)
    (package / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.8)\nproject(program LANGUAGES CXX)\nadd_executable(main main.cpp)\n"
    )
    check(built("program").failure, f"{SRC}/program", kind, place, summary, advice)


def test_a_missing_compiler_is_not_the_learners(
    built: Built, src: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for tool in ("cmake", "make", "sh"):
        (tmp_path / tool).symlink_to(f"/usr/bin/{tool}")
    monkeypatch.setenv("PATH", str(tmp_path))
    (src / "small_interfaces/new").touch()
    with pytest.raises(MissingHere) as caught:
        built("small_interfaces")
    assert caught.value.what == "Building small_interfaces needs cc and c++, which this machine lacks."
    assert caught.value.next_step == "sudo apt install gcc g++"


def check(
    failure: BuildFailure | None, folder: str, kind: str, places: str, summary: str, advice: str
) -> None:
    assert failure is not None
    feedback = failure.feedback
    assert failure.kind == kind, feedback
    assert [str(place) for place in feedback.where] == [f"{folder}/{place}" for place in places.split()]
    assert summary in feedback.summary
    assert feedback.summary.endswith(".")
    assert advice in str(feedback.advice)
    assert len(feedback.details) <= 6
    assert "/store/" not in "\n".join((feedback.summary, str(feedback.advice), *feedback.details))
    assert failure.log is not None
    assert failure.log.stat().st_size

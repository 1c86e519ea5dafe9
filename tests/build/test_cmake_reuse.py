"""A C++ build that resumes an earlier one ends as a build from nothing does."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from course.build import BuildOutcome, Interrupt, Store, Workspace, build, package_build
from course.build.cmake_reuse import is_plain_cmake
from course.build.colcon import colcon_command
from course.build.package_sources import copy_sources, source_files
from course.build.reuse import resumed
from course.rosenv import Ros
from tests.build.conftest import WORKSPACE
from tests.build.packages import edit, make_package
from tests.build.test_reuse import entry_of, tree

REPO = Path(__file__).parents[2]
LISTS = """cmake_minimum_required(VERSION 3.8)
project(talk)
add_compile_options(-Wall -Wextra -Wpedantic)
find_package(ament_cmake REQUIRED)
include_directories(include)
add_library(words src/words.cpp)
add_executable(talker src/talker.cpp src/other.cpp)
target_link_libraries(talker words)
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
install(TARGETS words DESTINATION lib)
install(DIRECTORY include config DESTINATION share/${PROJECT_NAME})
ament_package()
"""
FILES = {
    "CMakeLists.txt": LISTS,
    "config/talk.yaml": "name: first\n",
    "include/talk/words.hpp": "const char *words();\nconstexpr int count = 1;\n",
    "src/words.cpp": '#include <talk/words.hpp>\nconst char *words() { return "first"; }\n',
    "src/other.cpp": "int other() { return 1; }\n",
    "src/talker.cpp": "#include <cstdio>\n#include <talk/words.hpp>\nint other();\n"
    'int main() { std::printf("%s %d %d", words(), count, other()); }\n',
}


class Talk:
    """A library and a program that uses it. ran: what each build of it ran, "colcon" or "make"."""

    def __init__(self, home: Path, ros: Ros, store: Store) -> None:
        self.home, self.ros, self.store = home, ros, store
        self.folder = make_package(home / WORKSPACE / "src", "talk")
        edit(self.folder / "package.xml", "ament_python", "ament_cmake")
        for name, text in FILES.items():
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / name).write_text(text)
        self.ran: list[str] = []

    def build(self, store: Store | None = None, *, trusted: bool = True) -> BuildOutcome:
        workspace = Workspace.scan(self.home / WORKSPACE, trusted=trusted)
        return build(workspace, ["talk"], self.ros, store or self.store)

    def from_nothing(self) -> BuildOutcome:
        return self.build(Store(self.home.parent / "elsewhere"))


@pytest.fixture(scope="module")
def earlier(tmp_path_factory: pytest.TempPathFactory, ros: Ros) -> Store:
    """Contains the package as it is before any change."""
    top = tmp_path_factory.mktemp("earlier")
    store = Store(top / "store")
    assert Talk(top / "home", ros, store).build().failure is None
    return store


@pytest.fixture
def talk(home: Path, ros: Ros, earlier: Store, monkeypatch: pytest.MonkeyPatch) -> Talk:
    talk = Talk(home, ros, earlier)
    for name, command in (("colcon", colcon_command), ("make", package_build.make_command)):

        def recorded(*words: object, name: str = name, command: Callable[..., object] = command) -> object:
            talk.ran.append(name)
            return command(*words)

        monkeypatch.setattr(package_build, command.__name__, recorded)
    return talk


def said(outcome: BuildOutcome) -> str:
    return subprocess.run(
        [outcome.prefixes[0] / "lib/talk/talker"], capture_output=True, text=True, check=True
    ).stdout


@pytest.mark.slow
@pytest.mark.parametrize(
    ("changes", "says", "compiles"),
    [
        ("src/other.cpp:1:2", "first 1 2", "other"),
        ("src/words.cpp:first:second", "second 1 1", "words"),
        ("include/talk/words.hpp:1:3", "first 3 1", "talker words"),
        ("config/talk.yaml:first:second", "first 1 1", ""),
        ("src/words.cpp:first:second src/other.cpp:1:2 include/talk/words.hpp:1:3", "second 3 2",
         "other talker words"),
    ],
)  # fmt: skip
def test_changed_files_are_compiled(talk: Talk, changes: str, says: str, compiles: str) -> None:
    for change in changes.split():
        name, old, new = change.split(":")
        edit(talk.folder / name, old, new)
    resumed, anew = talk.build(), talk.from_nothing()
    assert talk.ran == ["make", "colcon"]
    assert said(resumed) == said(anew) == says
    assert tree(entry_of(resumed)) == tree(entry_of(anew))
    log = (entry_of(resumed) / "log/build.log").read_text()
    assert " ".join(sorted(re.findall(r"src/(\w+)\.cpp\.o", log))) == compiles
    # CMake would decide that by times in seconds, and this test is quicker.
    assert not [path for path in re.findall("Up-to-date: (.*)", log) if Path(path).is_file()]
    assert not (entry_of(resumed) / "build").exists()


@pytest.mark.slow
@pytest.mark.parametrize(
    "harm",
    [
        "src/other.cpp:return 1;:return 1",
        "src/other.cpp:other:another",  # the linker's
        "include/talk/words.hpp:int count = 1;:int counts = 1;",
        "src/words.cpp:<talk/words.hpp>:<talk/word.hpp>",
        "src/other.cpp:return 1;:int unused; return 1;",  # a warning
    ],
)
def test_the_compiler_says_the_same(talk: Talk, harm: str) -> None:
    def told(outcome: BuildOutcome) -> tuple[object, list[str]]:
        failure = outcome.failure
        log = failure.log if failure else entry_of(outcome) / "log/build.log"
        assert log is not None
        lines = log.read_text().replace(str(log.parents[1]), "ENTRY").splitlines()
        quoted = [line for line in lines if not re.match(r"(--|\[|Not searching|g?make|Install)", line)]
        return failure and (failure.kind, failure.feedback), quoted

    edit(talk.folder / harm.split(":")[0], *harm.split(":")[1:])
    resumed, anew = talk.build(), talk.from_nothing()
    assert talk.ran == ["make", "colcon"]
    assert told(resumed) == told(anew)
    assert any("other" in line or "words" in line for line in told(anew)[1])


@pytest.mark.slow
def test_submissions_share_no_build_folder(talk: Talk, store: Store) -> None:
    """Not with each other, and not with the learner's own packages: what one of them built may be forged."""
    assert list(talk.store.root.glob("*.like"))
    edit(talk.folder / "src/other.cpp", "1", "7")
    submitted = entry_of(talk.build(trusted=False))
    assert entry_of(talk.build(store, trusted=False)).name == submitted.name
    assert talk.ran == ["colcon", "colcon"]
    assert not list(submitted.glob("build")) and not list(store.root.glob("*.like"))
    edit(talk.folder / "src/other.cpp", "7", "8")
    assert said(talk.build(store)) == "first 1 8"
    assert talk.ran == ["colcon"] * 3


@pytest.mark.slow
def test_what_make_cannot_do_is_built_from_nothing(talk: Talk, monkeypatch: pytest.MonkeyPatch) -> None:
    """After an upgrade of the system, say: that is not the learner's failure."""
    says = "make[2]: *** No rule to make target '/usr/lib/libold.so.1', needed by 'talker'.  Stop."
    monkeypatch.setattr(
        package_build,
        "make_command",
        lambda *_: ["sh", "-c", f'touch build/talk/left; echo "{says}"; exit 2'],
    )
    edit(talk.folder / "src/other.cpp", "1", "6")
    assert said(talk.build()) == "first 1 6"
    assert talk.ran == ["colcon"]


OBJECT = "build/talk/CMakeFiles/talker.dir/src/other.cpp.o"


def date_it_tomorrow(entry: Path) -> None:
    later = time.time() + 86400
    os.utime(entry / OBJECT, (later, later))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("spoil", "resumes"),
    [
        (lambda entry: None, True),
        (lambda entry: (entry / OBJECT).write_bytes(b""), False),
        (lambda entry: (entry / "build/talk/GNUmakefile").write_text("all:"), False),
        (lambda entry: (entry / "src/src/words.cpp").write_text(""), False),
        (lambda entry: shutil.rmtree(entry / "build"), False),
        (date_it_tomorrow, False),
    ],
    ids=["as it was", "an object", "a makefile", "a source", "no folder", "tomorrow"],
)
def test_only_what_was_built_is_resumed(
    talk: Talk, earlier: Store, tmp_path: Path, spoil: Callable[[Path], object], resumes: bool
) -> None:
    store = Store(shutil.copytree(earlier.root, tmp_path / "copy"))
    like = next(store.root.glob("*.like"))
    spoil(store.root / like.read_text())
    entry = store.entry("0" * 32)
    entry.begin()
    edit(talk.folder / "src/other.cpp", "1", "5")
    copy_sources(talk.folder, talk.home, entry.src)
    os.utime(entry.src / "src/other.cpp", (1, 1))  # a source that was copied before the earlier build ended
    with Interrupt() as interrupt:
        assert resumed(store, like.stem, entry.path.name, (), talk.ros.identity, interrupt) == resumes
    assert (entry.path / OBJECT).exists() == resumes
    if resumes:
        names = ("src/src/words.cpp", OBJECT, "src/src/other.cpp")
        times = [(entry.path / name).stat().st_mtime for name in names]
        assert times == sorted(set(times))


PLAIN = [
    *("26-cpp-nodes/ros2_tutorial_workspace/src/cpp_package_with_a_node",),
    *("27-cpp-libraries/ros2_tutorial_workspace/src/cpp_package_with_a_library",),
    *("31-a-robot-driver/sas_tutorial_workspace/src/sas_robot_driver_myrobot",),
]


@pytest.mark.parametrize("package", PLAIN)
def test_the_course_has_plain_packages(package: str) -> None:
    folder = REPO / "solutions" / package
    assert is_plain_cmake(source_files(folder, folder))


@pytest.mark.parametrize(
    "line",
    [
        "execute_process(COMMAND ./evil)",
        "EXECUTE_PROCESS(COMMAND ./evil)",
        "add_custom_command(TARGET talker POST_BUILD COMMAND talker)",
        "add_custom_target(evil ALL COMMAND talker)",
        "include(evil.cmake)",
        "add_subdirectory(evil)",
        "macro(set)\nendmacro()",
        "file(READ config/talk.yaml NAME)",
        "configure_file(config/talk.yaml talk.hpp)",
        "try_run(A B . src/other.cpp)",
        "rosidl_generate_interfaces(talk msg/A.msg)",
        "ament_python_install_package(talk)",
        "install(CODE evil)",
        "install(SCRIPT evil.cmake)",
        "set(CMAKE_CXX_FLAGS $(evil))",
        "set(CMAKE_CXX_COMPILER evil)",
        "set(CMAKE_CXX_COMPILER_LAUNCHER evil)",
        "set(ENV{PATH} evil)",
        "set(${NAME} evil)",
        "set_target_properties(talker PROPERTIES CXX_COMPILER_LAUNCHER evil)",
        "set_target_properties(talker PROPERTIES RULE_LAUNCH_LINK evil)",
        "add_compile_options(-fplugin=evil.so)",
        "add_compile_options(-wrapper evil)",
        "add_compile_options(@evil)",
        "add_compile_options(-specs=evil)",
        "add_compile_options(-Bevil)",
        "message([[\n]] )\nexecute_process(COMMAND evil)",
        'message(\\"\nexecute_process(COMMAND evil)',
    ],
)
def test_what_may_run_programs_is_not_plain(tmp_path: Path, line: str) -> None:
    (tmp_path / "CMakeLists.txt").write_text(LISTS)
    assert is_plain_cmake(source_files(tmp_path, tmp_path))
    (tmp_path / "CMakeLists.txt").write_text(LISTS.replace("ament_package", f"{line}\nament_package"))
    assert not is_plain_cmake(source_files(tmp_path, tmp_path))


def test_only_one_list_is_plain(tmp_path: Path) -> None:
    (tmp_path / "inner").mkdir()
    for name in ("CMakeLists.txt", "inner/CMakeLists.txt"):
        (tmp_path / name).write_text(LISTS)
    assert not is_plain_cmake(source_files(tmp_path, tmp_path))
    (tmp_path / "inner/CMakeLists.txt").unlink()
    (tmp_path / "src.cpp").write_text('asm(".incbin "config/talk.yaml"");')
    assert not is_plain_cmake(source_files(tmp_path, tmp_path))

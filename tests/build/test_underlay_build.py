"""Which of our own packages a build needs, and that they exist afterwards."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from course.build import Interrupt, Workspace
from course.build import underlay_build as underlay
from course.build.underlay_build import build_underlay, provide
from course.errors import OurFault
from course.rosenv import Ros, find_ros, missing_of_underlay, node_environment, prepare
from course.rosenv.underlay import UnderlayPackage
from tests.rosenv.made_up import write

NAMES = ("interfaces", "hooks")


@pytest.fixture
def asked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What would have been built on a fresh machine."""
    names: list[str] = []
    write(tmp_path / "ours/interfaces/msg/Word.msg", "string text\n")
    missing = tuple(UnderlayPackage(name, tmp_path / "ours" / name, True) for name in NAMES)
    monkeypatch.setattr(underlay, "missing_of_underlay", lambda ros: missing)
    monkeypatch.setattr(underlay, "build_underlay", lambda wanted, ros, **_: names.extend(wanted))
    return names


def workspace(tmp_path: Path, tags: str = "", code: str = "", cmake: str = "") -> Workspace:
    folder = tmp_path / "home/ws/src/mine"
    head = '<package format="3"><name>mine</name>'
    write(
        folder / "package.xml",
        f"{head}{tags}<export><build_type>ament_python</build_type></export></package>",
    )
    write(folder / "mine/node.py", code)
    write(folder / "CMakeLists.txt", cmake)
    write(folder / "notes.bin", "interfaces")
    return Workspace.scan(tmp_path / "home/ws")


@pytest.mark.parametrize(
    ("tags", "code", "needed"),
    [
        ("", "", []),
        ("<depend>interfaces</depend>", "", ["interfaces"]),
        ("<exec_depend>hooks</exec_depend>", "", ["hooks"]),
        ("<test_depend>hooks</test_depend>", "", []),
        ("", "from interfaces.msg import Word", ["interfaces"]),
        ("", "import hooks", []),
    ],
)
def test_what_is_declared_or_mentioned_is_needed(
    tmp_path: Path, asked: list[str], tags: str, code: str, needed: list[str]
) -> None:
    provide(workspace(tmp_path, tags, code), ["mine"], find_ros())
    assert asked == needed


@pytest.mark.parametrize(
    ("cmake", "needed"),
    [
        ("find_package(hooks REQUIRED)\n", ["hooks"]),
        ("  find_package ( hooks)\n", ["hooks"]),
        ("# find_package(hooks)\n", []),
        ("find_package(hooks_of_others)\n", []),
        ("if(BUILD_TESTING)\n  find_package(hooks)\nendif()\n", []),
        ("if(BUILD_TESTING)\nendif()\nfind_package(hooks)\n", ["hooks"]),
    ],
)
def test_what_cmake_finds_is_needed_though_it_was_not_declared(
    tmp_path: Path, asked: list[str], cmake: str, needed: list[str]
) -> None:
    provide(workspace(tmp_path, cmake=cmake), ["mine"], find_ros())
    assert asked == needed


def test_only_the_packages_that_are_to_be_built_count(tmp_path: Path, asked: list[str]) -> None:
    provide(workspace(tmp_path, "<depend>interfaces</depend>"), ["absent"], find_ros())
    assert asked == []


def test_an_installed_ros_needs_nothing_of_ours(tmp_path: Path) -> None:
    ros = Ros("installed", "jazzy", tmp_path, tmp_path / "python3", "identity")
    assert missing_of_underlay(ros) == ()


def test_one_of_ours_that_does_not_build_is_our_fault(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write(tmp_path / "src/bad/package.xml", "<package/>")
    monkeypatch.setattr(underlay, "source_root", lambda: tmp_path)
    monkeypatch.setattr(underlay, "underlay_builds", lambda ros: tmp_path / "builds")
    with pytest.raises(OurFault, match="bad of the course's own packages does not build here"):
        build_underlay(["bad"], find_ros())


@pytest.mark.slow
def test_what_was_built_is_found_by_nodes_and_by_cmake(tmp_path: Path) -> None:
    ros = find_ros()
    prepare(ros)
    with Interrupt() as stop:
        build_underlay(["example_interfaces", "ament_lint_auto"], ros, interrupt=stop)
    assert {"example_interfaces", "ament_lint_auto"}.isdisjoint(p.name for p in missing_of_underlay(ros))
    code = "from example_interfaces.srv import AddTwoInts; print(AddTwoInts.Request(a=1, b=2).b)"
    command = [str(ros.python), "-c", code]
    done = subprocess.run(command, env=node_environment(ros), capture_output=True, text=True, check=False)
    assert (done.stdout, done.stderr) == ("2\n", "")
    write(
        tmp_path / "CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.8)\nproject(user)\nfind_package(example_interfaces REQUIRED)\n"
        "find_package(ament_lint_auto REQUIRED)\n",
    )
    cmake = ["cmake", "-S", str(tmp_path), "-B", str(tmp_path / "build")]
    done = subprocess.run(cmake, env=node_environment(ros), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr

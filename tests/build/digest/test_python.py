"""Faults of setup.py and setup.cfg."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.build.digest import Case, explain
from course.build.digest.setup_source import entry_points
from tests.build.conftest import SRC
from tests.build.digest.logs import check


@pytest.mark.parametrize(
    "where", [["file: 'setup.cfg', line: 1", "'[install\\n'"], ["in 'setup.cfg'", "\t[line  1]: 'x'"]]
)
def test_a_bad_setup_cfg(case: Callable[..., Case], src: Path, where: list[str]) -> None:
    (src / "small_node/setup.cfg").write_text("[install\n")
    said = [
        "Traceback (most recent call last):",
        '  File "/python/configparser.py", line 1101, in _read',
        "configparser.MissingSectionHeaderError: File contains no section headers.",
        *where,
    ]
    failure = explain(case("small_node", "", said))
    check(failure, "setup-cfg", f"{SRC}/small_node/setup.cfg:1", "setup.cfg of `small_node`", "`[install]`")


@pytest.mark.parametrize(
    ("error", "advice"),
    [
        ("NameError: name 'glob' is not defined", "Add `from glob import glob` at the top"),
        ("TypeError: 'module' object is not callable", "`from glob import glob`, not `import glob`"),
        ("TypeError: 'tuple' object is not callable", "A comma is missing"),
        ("ModuleNotFoundError: No module named 'numpie'", "Correct or remove that import"),
        ("ValueError: odd", "Run `python3 setup.py --name`"),
    ],
)
def test_an_exception_of_setup_py(case: Callable[..., Case], error: str, advice: str) -> None:
    said = [
        "Traceback (most recent call last):",
        f'  File "{SRC}/small_node/setup.py", line 8, in <module>',
        "    packages=glob('*'),",
        "             ^^^^",
        error,
    ]
    failure = explain(case("small_node", "", said))
    check(failure, "setup-py", f"{SRC}/small_node/setup.py:8", f"stops with {error}.", advice)
    assert failure.feedback.details[-1] == error


def test_a_folder_that_is_not_there(case: Callable[..., Case]) -> None:
    log = "running build_py\nerror: package directory 'other' does not exist\n"
    failure = explain(case("small_node", log))
    check(
        failure,
        "package-folder",
        f"{SRC}/small_node/setup.py:8",
        "lists the Python package other",
        "find_packages",
    )


def test_setup_py_missing_and_empty(case: Callable[..., Case], src: Path) -> None:
    (src / "small_node/setup.py").write_text("")
    place = f"{SRC}/small_node/setup.py"
    check(explain(case("small_node", "")), "setup-py", place, "setup.py of `small_node` is empty", "None")
    (src / "small_node/setup.py").unlink()
    place = f"{SRC}/small_node/package.xml:12"
    check(explain(case("small_node", "")), "setup-missing", place, "has no setup.py", "ros2 pkg create")
    (src / "small_node/CMakeLists.txt").write_text("project(x)")
    check(
        explain(case("small_node", "")),
        "build-type",
        place,
        "a CMakeLists.txt and no setup.py",
        "ament_cmake",
    )


def test_setup_that_is_never_called(case: Callable[..., Case]) -> None:
    log = "RuntimeError: 'distutils.core.setup()' was never called -- perhaps 'setup.py' is not a script?"
    failure = explain(case("small_node", log))
    check(failure, "setup-py", f"{SRC}/small_node/setup.py", "never calls `setup(...)`", "end of the file")


def test_what_setuptools_refuses_is_quoted(case: Callable[..., Case]) -> None:
    said = ["error in small_node setup command: 'install_requires' must be a string."]
    failure = explain(case("small_node", "", said))
    place = f"{SRC}/small_node/setup.py"
    check(failure, "setup-py", place, "refuses setup.py of `small_node`: 'install_requires' must be", "None")


@pytest.mark.parametrize(
    ("items", "sound", "joined"),
    [
        ("'a = m:f', 'b = m:g'", [True, True], [False, False]),
        ("'a = m:f'\n 'b = m:g'", [False], [True]),
        ("'a = '\n 'm:f', 'b = m:g'", [True, True], [False, False]),
        ("'ä = ü:f', 'a = m.n:C.f'", [True, True], [False, False]),
        ("'a = m/n.py:f'", [False], [False]),
        ("'a = m.f'", [False], [False]),
    ],
)
def test_entry_points_are_read_without_running(items: str, sound: list[bool], joined: list[bool]) -> None:
    points = entry_points(f"setup(entry_points={{'console_scripts': [\n {items},\n]}})\n")
    assert [point.is_sound for point in points] == sound
    assert [point.is_joined for point in points] == joined


def test_what_cannot_be_parsed_has_no_entry_points() -> None:
    assert entry_points("setup(") == []

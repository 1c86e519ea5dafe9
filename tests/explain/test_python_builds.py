"""Faults of setup.py and setup.cfg."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.evidence.sources import Sources
from course.explain.build_errors import explain_build
from course.explain.builds import Build
from course.explain.setup_py import entry_points
from tests.build.conftest import SRC
from tests.golden import golden


@pytest.mark.parametrize(
    "where", [["file: 'setup.cfg', line: 1", "'[install\\n'"], ["in 'setup.cfg'", "\t[line  1]: 'x'"]]
)
def test_a_bad_setup_cfg(case: Callable[..., Build], src: Path, where: list[str]) -> None:
    (src / "small_node/setup.cfg").write_text("[install\n")
    said = [
        "Traceback (most recent call last):",
        '  File "/python/configparser.py", line 1101, in _read',
        "configparser.MissingSectionHeaderError: File contains no section headers.",
        *where,
    ]
    golden(explain_build(case("small_node", "", said)))


@pytest.mark.parametrize(
    "error",
    [
        "NameError: name 'glob' is not defined",
        "TypeError: 'module' object is not callable",
        "TypeError: 'tuple' object is not callable",
        "ModuleNotFoundError: No module named 'numpie'",
        "ValueError: odd",
    ],
)
def test_an_exception_of_setup_py(case: Callable[..., Build], error: str) -> None:
    said = [
        "Traceback (most recent call last):",
        f'  File "{SRC}/small_node/setup.py", line 8, in <module>',
        "    packages=glob('*'),",
        "             ^^^^",
        error,
    ]
    golden(explain_build(case("small_node", "", said)))


def test_a_folder_that_is_not_there(case: Callable[..., Build]) -> None:
    golden(
        explain_build(
            case("small_node", "running build_py\nerror: package directory 'other' does not exist\n")
        )
    )


def test_setup_py_missing_and_empty(case: Callable[..., Build], src: Path) -> None:
    (src / "small_node/setup.py").write_text("")
    golden(explain_build(case("small_node", "")))
    (src / "small_node/setup.py").unlink()
    golden(explain_build(case("small_node", "")))
    (src / "small_node/CMakeLists.txt").write_text("project(x)")
    golden(explain_build(case("small_node", "")))


def test_setup_that_is_never_called(case: Callable[..., Build]) -> None:
    log = "RuntimeError: 'distutils.core.setup()' was never called -- perhaps 'setup.py' is not a script?"
    golden(explain_build(case("small_node", log)))


def test_what_setuptools_refuses_is_quoted(case: Callable[..., Build]) -> None:
    said = ["error in small_node setup command: 'install_requires' must be a string."]
    golden(explain_build(case("small_node", "RuntimeError: setup() was never called", said)))


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
    text = f"setup(entry_points={{'console_scripts': [\n {items},\n]}})\n"
    points = entry_points(Sources({"talk/setup.py": text}), "talk")
    assert [point.is_sound for point in points] == sound
    assert [point.is_joined for point in points] == joined


def test_what_cannot_be_parsed_has_no_entry_points() -> None:
    assert entry_points(Sources({"talk/setup.py": "setup("}), "talk") == ()

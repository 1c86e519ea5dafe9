"""CMake's first error for a project that is not a ROS package."""

from __future__ import annotations

import pytest

from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.explain.cmake_errors import not_configured
from course.model.events import OutputLine
from tests.golden import golden

FOLDER = "project"
LISTS = f"{FOLDER}/CMakeLists.txt"


def printed(text: str) -> Recording:
    lines = (OutputLine(0.1, "configure", line) for line in text.splitlines())
    return Recording("x", tuple(lines), sources=Sources({LISTS: ""}))


def at(line: int, command: str, text: str) -> str:
    return (
        f"-- fine\nCMake Error at CMakeLists.txt:{line} ({command}):\n  {text}\n\n-- Configuring incomplete\n"
    )


@pytest.mark.parametrize(
    "text",
    [
        'Could not find a package configuration file provided by "door" with any',
        "Could not find TINYQP using the following names: tinyqp",
        'Target "x" links to:\n\n    door::dor\n\n  but the target was not found.',
        "Cannot find source file:\n\n    main.cpp",
        'Unknown CMake command "find_packge".',
        "Something quite new. It goes on.",
    ],
)
def test_causes_have_their_place(text: str) -> None:
    golden(not_configured(printed(at(4, "x", text)), "configure", FOLDER))


def test_a_call_deep_in_cmake_is_the_learners_line() -> None:
    text = (
        "CMake Error at /usr/share/cmake/x.cmake:53 (message):\n  Could not find a package configuration\n"
        '  file provided by "door"\nCall Stack (most recent call first):\n  CMakeLists.txt:7 (find_package)\n'
    )
    golden(not_configured(printed(text), "configure", FOLDER))


def test_without_an_error_of_cmakes_its_last_lines_are_shown() -> None:
    golden(not_configured(printed("one\ntwo\n"), "configure", FOLDER))

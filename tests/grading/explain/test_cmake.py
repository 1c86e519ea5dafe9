"""CMake's first error for a project that is no ROS package."""

from __future__ import annotations

import pytest

from course.evidence.events import OutputLine
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.grading.explain.cmake import not_configured

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
    ("text", "summary", "advice"),
    [
        ('Could not find a package configuration file provided by "door" with any', "`door`", "folder"),
        ("Could not find TINYQP using the following names: tinyqp", "does not find `TINYQP`", "folder"),
        ('Target "x" links to:\n\n    door::dor\n\n  but the target was not found.', "`door::dor`", "above"),
        ("Cannot find source file:\n\n    main.cpp", "no source file `main.cpp`", "Make the file"),
        ('Unknown CMake command "find_packge".', "`find_packge` is no CMake command", "letter by letter"),
        ("Something quite new. It goes on.", "configure the project: Something quite new.", "Read what"),
    ],
)  # fmt: skip
def test_causes_have_their_place(text: str, summary: str, advice: str) -> None:
    feedback = not_configured(printed(at(4, "x", text)), "configure", FOLDER)
    assert summary in feedback.summary and advice in (feedback.advice or "")
    assert [str(place) for place in feedback.where] == [f"{LISTS}:4"]


def test_a_call_deep_in_cmake_is_the_learners_line() -> None:
    text = (
        "CMake Error at /usr/share/cmake/x.cmake:53 (message):\n  Could not find a package configuration\n"
        '  file provided by "door"\nCall Stack (most recent call first):\n  CMakeLists.txt:7 (find_package)\n'
    )
    feedback = not_configured(printed(text), "configure", FOLDER)
    assert [str(place) for place in feedback.where] == [f"{LISTS}:7"] and "`door`" in feedback.summary


def test_without_an_error_of_cmakes_its_last_lines_are_shown() -> None:
    feedback = not_configured(printed("one\ntwo\n"), "configure", FOLDER)
    assert feedback.details == ("one", "two") and [str(place) for place in feedback.where] == [LISTS]

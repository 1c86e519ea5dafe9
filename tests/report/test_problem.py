"""Errors name what happened and the next step."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from course.report.problem import render_bug, render_problem

if TYPE_CHECKING:
    from tests.report.conftest import Page


def test_what_and_next_step(page: Page) -> None:
    render_problem(page.console, "no course home", "make one: `ros2course init`")
    assert page.lines == ["Error: No course home.", "Next: Make one: `ros2course init`"]


def test_an_id_or_a_path_keeps_its_case(page: Page) -> None:
    render_problem(page.console, "/tmp/x/lesson.yaml:3: wrong")
    render_problem(page.console, "chapters/x/lesson.yaml:3: wrong")
    render_problem(page.console, "bad_roster.csv is no roster")
    assert page.lines == [
        "Error: /tmp/x/lesson.yaml:3: wrong",
        "Error: chapters/x/lesson.yaml:3: wrong",
        "Error: bad_roster.csv is no roster.",
    ]


def test_a_command_can_be_copied(page: Page) -> None:
    render_problem(page.console, "The C++ library Eigen 3 is not here", "sudo apt install libeigen3-dev")
    assert page.lines[1] == "Next: sudo apt install libeigen3-dev"


def test_steps_on_lines_of_their_own(page: Page) -> None:
    render_problem(page.console, "It broke.", "first\n\nsecond")
    assert page.lines[1:] == ["Next: First.", "      Second."]


def test_a_bug_names_its_log(page: Page) -> None:
    render_bug(page.console, "ValueError: \x1b[31mx\ny", Path("/tmp/a very/long path" + "/x" * 40))
    assert page.lines[0] == "An error in the course, not yours: ValueError: x\\ny"
    assert page.lines[1] == "The details are in /tmp/a very/long path" + "/x" * 40

"""Exercises about the learner's own machine: made here, since no tree of files solves them."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from course.content import Course
from course.grading.check import Request, check_exercise
from course.model.result import Outcome, Verdict
from course.rosenv import find_ros

from .conftest import Check

pytestmark = pytest.mark.slow


def make_environment(folder: Path) -> None:
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", str(folder)], check=True)


def test_a_virtual_environment(course: Course, home: Path, check: Check) -> None:
    make_environment(home / "ros2tutorial_venv")
    result = check(course.exercise("02-venv"), home)
    assert result.verdict is Verdict.PASSED, result
    bonus = next(one for one in result.checks if one.id == "dqrobotics")
    assert bonus.outcome is Outcome.NOT_APPLICABLE
    assert "pip install dqrobotics" in (bonus.skipped_because or "")


def test_one_of_another_name_is_named(course: Course, home: Path, check: Check) -> None:
    make_environment(home / "ros2_venv")
    made = check(course.exercise("02-venv"), home).checks[0]
    assert made.outcome is Outcome.FAILED
    assert made.feedback is not None and "but `~/ros2_venv` does" in made.feedback.summary


def test_one_whose_python_is_gone(course: Course, home: Path, check: Check) -> None:
    make_environment(home / "ros2tutorial_venv")
    (home / "ros2tutorial_venv/bin/python3").unlink()
    outcomes = {one.id: one for one in check(course.exercise("02-venv"), home).checks}
    assert outcomes["made"].outcome is Outcome.PASSED
    runs = outcomes["runs"]
    assert runs.feedback is not None and "no working Python" in runs.feedback.summary


def test_a_submission_has_none(course: Course, home: Path) -> None:
    result = check_exercise(Request(course.exercise("02-venv"), home, ros=find_ros(), local=False))
    assert result.verdict is Verdict.NOT_APPLICABLE


@pytest.mark.parametrize(
    ("line", "unjudged"),
    [
        ("source /home/somebody/ros/setup.bash\n", {"distro", "ros2"}),
        ("F=/home/somebody/ros/setup.bash; [ -f $F ] && . $F\n", {"once", "distro", "ros2"}),
    ],
)
def test_a_submission_names_a_ros_that_only_its_own_machine_has(
    course: Course, home: Path, line: str, unjudged: set[str]
) -> None:
    (home / ".bashrc").write_text(line)
    result = check_exercise(Request(course.exercise("03-environment"), home, ros=find_ros(), local=False))
    assert {one.id for one in result.checks if one.outcome is Outcome.NOT_APPLICABLE} == unjudged
    assert not [one for one in result.checks if one.outcome is Outcome.FAILED]

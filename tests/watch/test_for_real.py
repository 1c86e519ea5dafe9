"""`watch` with the real check of a real exercise: a mistake, its repair, and Ctrl+C in the middle."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from course.content import open_course
from course.grading import trial
from course.progress import Progress
from tests.watch.conftest import REAL, REPO

if TYPE_CHECKING:
    from tests.watch.conftest import Seat

pytestmark = pytest.mark.slow
EXERCISE = "12-print-forever"


def test_from_a_mistake_to_the_pass(seat: Seat, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("_ROS_WHEELS_BOOTSTRAP_COMPLETE", "1")
    monkeypatch.setattr("tests.watch.conftest.PATIENCE", 300)
    course = open_course(REPO)
    exercise = course.exercise(EXERCISE)
    trial.lay_solution(course, exercise, seat.home)
    node = seat.home / exercise.files[0]
    right = node.read_text()
    seat.script, seat.course = REAL, REPO
    seat.sit_down(EXERCISE)
    seat.see("Chapter 12", "q quit")
    node.write_text(right.replace("def ", "deff ", 1))
    seat.see("Not passed yet", "points")
    node.write_text(right)
    seat.see("Passed: ", "passes now", "Press n for the next exercise.")
    node.write_text(f"{right}\n# once more\n")
    seat.see("watching your program")
    seat.child.sendintr()
    assert seat.ended() == 130
    with Progress.open(seat.home / ".ros2course") as progress:
        assert progress.state(EXERCISE) == "passed"

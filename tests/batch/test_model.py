"""Tasks and gradings travel as lines."""

from __future__ import annotations

import json

import pytest

from course.batch.model import Task, Unit, graded_from_line, graded_to_line, task_from_line, task_to_line
from tests.batch.samples import FAILED, graded


def test_a_task_travels() -> None:
    task = Task(Unit("jörg\n", "18-publisher", 2), "home", "evidence.mcap", "course", contained=False)
    line = task_to_line(task)
    assert "\n" not in line
    assert task_from_line(line) == task


def test_a_grading_travels() -> None:
    line = graded_to_line(graded("ada", FAILED))
    assert "\n" not in line
    assert graded_from_line(line) == graded("ada", FAILED)


def test_another_attempt_is_of_the_same() -> None:
    assert Unit("ada", "18-publisher").again() == Unit("ada", "18-publisher", 2)


@pytest.mark.parametrize(
    "line",
    [
        "",
        "rubbish",
        "[]",
        "3",
        "{}",
        json.dumps({"unit": [], "result": "{}", "seconds": 1}),
        json.dumps({"unit": {"person": "a", "exercise": "b"}, "result": "{}", "seconds": 1}),
        json.dumps({"unit": {"person": "a", "exercise": "b", "x": 1}, "result": "{}", "seconds": 1}),
        json.dumps({"unit": {"person": "a", "exercise": "b"}, "result": None, "seconds": 1}),
    ],
)
def test_what_no_worker_wrote_is_told_from_an_answer(line: str) -> None:
    with pytest.raises((ValueError, KeyError, TypeError)):
        graded_from_line(line)

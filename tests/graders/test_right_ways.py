"""Every right way to solve an exercise earns all points; no starter passes."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import Alternative, Course, Exercise, open_course
from course.grading import trial
from course.grading.result import Outcome, Result, Verdict

from .conftest import Check

pytestmark = pytest.mark.slow

EXERCISES = open_course().exercises()
# No tree of files solves what is about the learner's own machine; see test_own_machine.py.
SOLVED = [exercise for exercise in EXERCISES if not exercise.local_only]
OTHER_WAYS = [(exercise, other) for exercise in EXERCISES for other in exercise.alternatives()]


def complaints(result: Result) -> list[str]:
    """All that kept this result from full points, for the test's own message."""
    fault = [f"our error: {result.fault.summary} {result.fault.details}"] if result.fault else []
    others = [check for check in result.checks if check.outcome is not Outcome.PASSED]
    return [*fault, *(f"{check.id}: {check.feedback or check.skipped_because}" for check in others)]


@pytest.mark.parametrize("exercise", SOLVED, ids=lambda e: e.id)
def test_the_reference_earns_all_points(exercise: Exercise, course: Course, home: Path, check: Check) -> None:
    trial.lay_solution(course, exercise, home)
    result = check(exercise, home)
    assert complaints(result) == []
    assert result.verdict is Verdict.PASSED
    assert result.points >= result.max_points > 0


@pytest.mark.parametrize(("exercise", "other"), OTHER_WAYS, ids=[f"{e.id}-{o.name}" for e, o in OTHER_WAYS])
def test_other_right_ways_earn_all_points(
    exercise: Exercise, other: Alternative, course: Course, home: Path, check: Check
) -> None:
    trial.lay_alternative(course, exercise, other, home)
    result = check(exercise, home)
    assert complaints(result) == []
    assert result.verdict is Verdict.PASSED


@pytest.mark.parametrize("exercise", EXERCISES, ids=lambda e: e.id)
def test_the_starter_runs_but_does_not_pass(
    exercise: Exercise, course: Course, home: Path, check: Check
) -> None:
    trial.lay_starter(course, exercise, home)
    result = check(exercise, home)
    assert result.verdict is Verdict.NOT_PASSED, complaints(result)
    if exercise.starter.is_dir() and exercise.packages:  # else the learner begins with an empty workspace
        assert next(c for c in result.checks if c.id == "builds").outcome is Outcome.PASSED

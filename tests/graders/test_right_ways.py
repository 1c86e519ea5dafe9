"""Every right way to solve an exercise earns all points; no starter passes."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import Alternative, Course, Exercise, open_course
from course.grading import trial
from course.validate.judge import does_not_pass, earns_all
from course.validate.plan import starter_builds

from .conftest import Check

pytestmark = pytest.mark.slow

EXERCISES = open_course().exercises()
# No tree of files solves what is about the learner's own machine; see test_own_machine.py.
SOLVED = [exercise for exercise in EXERCISES if not exercise.local_only]
OTHER_WAYS = [(exercise, other) for exercise in EXERCISES for other in exercise.alternatives()]


@pytest.mark.parametrize("exercise", SOLVED, ids=lambda e: e.id)
def test_the_reference_earns_all_points(exercise: Exercise, course: Course, home: Path, check: Check) -> None:
    trial.lay_solution(course, exercise, home)
    assert earns_all(check(exercise, home)) == []


@pytest.mark.parametrize(("exercise", "other"), OTHER_WAYS, ids=[f"{e.id}-{o.name}" for e, o in OTHER_WAYS])
def test_other_right_ways_earn_all_points(
    exercise: Exercise, other: Alternative, course: Course, home: Path, check: Check
) -> None:
    trial.lay_alternative(course, exercise, other, home)
    assert earns_all(check(exercise, home)) == []


@pytest.mark.parametrize("exercise", EXERCISES, ids=lambda e: e.id)
def test_the_starter_runs_but_does_not_pass(
    exercise: Exercise, course: Course, home: Path, check: Check
) -> None:
    trial.lay_starter(course, exercise, home)
    assert does_not_pass(check(exercise, home), builds=starter_builds(exercise)) == []

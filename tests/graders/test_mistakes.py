"""Every known mistake is caught by the check that is meant to, in words that name it."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import Course, Exercise, Mistake, open_course
from course.grading import trial
from course.validate.judge import is_caught

from .conftest import Check

pytestmark = pytest.mark.slow

MISTAKES = [(exercise, mistake) for exercise in open_course().exercises() for mistake in exercise.mistakes()]


@pytest.mark.parametrize(("exercise", "mistake"), MISTAKES, ids=[f"{e.id}-{m.id}" for e, m in MISTAKES])
def test_mistake(exercise: Exercise, mistake: Mistake, course: Course, home: Path, check: Check) -> None:
    trial.lay_mistake(course, exercise, mistake, home)
    assert is_caught(check(exercise, home), mistake) == []

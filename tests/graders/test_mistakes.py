"""Every known mistake is caught by the check that is meant to, in words that name it."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import Course, Exercise, Mistake, open_course
from course.grading import trial
from course.grading.result import Feedback, Outcome, Verdict

from .conftest import Check

pytestmark = pytest.mark.slow

MISTAKES = [(exercise, mistake) for exercise in open_course().exercises() for mistake in exercise.mistakes()]


def words(feedback: Feedback | None) -> str:
    """Everything that a learner reads of it."""
    if feedback is None:
        return ""
    parts = (feedback.summary, feedback.expected, feedback.seen, feedback.advice)
    return "\n".join([part for part in parts if part] + [*map(str, feedback.where), *feedback.details])


@pytest.mark.parametrize(("exercise", "mistake"), MISTAKES, ids=[f"{e.id}-{m.id}" for e, m in MISTAKES])
def test_mistake(exercise: Exercise, mistake: Mistake, course: Course, home: Path, check: Check) -> None:
    trial.lay_mistake(course, exercise, mistake, home)
    result = check(exercise, home)
    by_id = {done.id: done for done in result.checks}
    failed = {done.id for done in result.checks if done.outcome is Outcome.FAILED}
    assert mistake.caught_by in failed, failed
    said = words(by_id[mistake.caught_by].feedback)
    assert [word for word in mistake.says if word not in said] == [], said
    assert failed == {mistake.caught_by, *mistake.also_fails}
    spares_the_pass = all(by_id[name].bonus for name in failed)
    assert result.verdict is (Verdict.PASSED if spares_the_pass else Verdict.NOT_PASSED), result

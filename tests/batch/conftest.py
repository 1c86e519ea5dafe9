"""A class that answers a quiz: graded for real and quickly, without running any program."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.content import Course, open_course
from course.grading import trial
from tests.batch.samples import QUIZ
from tests.conftest import FIXTURES

Lay = Callable[..., Path]


@pytest.fixture(scope="session")
def quiz_course() -> Course:
    return open_course(FIXTURES / "quiz_course")


@pytest.fixture
def lay(quiz_course: Course, tmp_path: Path) -> Lay:
    """`lay("ada", "bao", mistake="saves-oil")`: submissions of these people; returns the class's folder."""
    folder = tmp_path / "class"
    exercise = quiz_course.exercise(QUIZ)
    mistakes = {mistake.id: mistake for mistake in exercise.mistakes()}

    def of(*people: str, mistake: str | None = None) -> Path:
        for person in people:
            (folder / person).mkdir(parents=True, exist_ok=True)
            trial.lay_solution(quiz_course, exercise, folder / person)
            if mistake:
                trial.apply_mistake(exercise, mistakes[mistake], folder / person)
        return folder

    return of

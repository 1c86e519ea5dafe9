"""The exercises of the real course, and submissions to look at."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.batch.intake import Found, Upload, look
from course.batch.intake.submission import Part
from course.content import Exercise, open_course
from course.model.gradebook import Person


@pytest.fixture(scope="session")
def exercises() -> tuple[Exercise, ...]:
    return open_course().exercises()


@pytest.fixture
def looked(tmp_path: Path, exercises: tuple[Exercise, ...]) -> Callable[..., Found]:
    """`looked(path, ...)`: what one person's submission of these parts contains."""

    def of(*paths: Path) -> Found:
        parts = tuple(Part(path.name, path) for path in paths)
        return look(Upload(Person("jane", "Jane"), "jane", parts), tmp_path / "opened", exercises)

    return of

"""A course home, and the exercises of the small course to work on in it."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.content import Exercise, open_course
from course.home import CourseHome, create_home


@pytest.fixture
def home(tmp_path: Path) -> CourseHome:
    return create_home(tmp_path / "home")


@pytest.fixture
def light(small_course: Path) -> Exercise:
    return open_course(small_course).exercise("04-light")


@pytest.fixture
def dim(small_course: Path) -> Exercise:
    return open_course(small_course).exercise("04-dim")

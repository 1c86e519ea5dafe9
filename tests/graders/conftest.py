"""Real grading: trial homes, one build store for all tests of a run, a check in one call."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.build import Store
from course.content import Course, Exercise, open_course
from course.grading.check import Request, check_exercise
from course.grading.trial_answers import SEED
from course.home import create_home
from course.model.result import Result
from course.rosenv import find_ros

Check = Callable[[Exercise, Path], Result]


@pytest.fixture(scope="session")
def course() -> Course:
    return open_course()


@pytest.fixture(scope="session")
def store(shared_builds: Store) -> Store:
    return shared_builds


@pytest.fixture
def home(tmp_path: Path) -> Path:
    return create_home(tmp_path / "home").path


@pytest.fixture
def check(store: Store) -> Check:
    ros = find_ros()
    return lambda exercise, home: check_exercise(Request(exercise, home, ros=ros, store=store, seed=SEED))

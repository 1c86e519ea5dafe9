"""A recording that is kept, one that cannot be kept, and one that cannot be judged."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.content import Course, Exercise, open_course
from course.evidence.mcap_file import load
from course.grading import trial
from course.grading.check import Helpers, Request, attempt_exercise
from course.grading.judge.judges import Judge
from course.grading.protocol import Judgment
from course.home import create_home
from course.model.result import Verdict
from course.rosenv import find_ros

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def course() -> Course:
    return open_course()


@pytest.fixture
def exercise(course: Course) -> Exercise:
    return course.exercise("02-script")


@pytest.fixture
def home(course: Course, exercise: Exercise, tmp_path: Path) -> Path:
    home = create_home(tmp_path / "home").path
    trial.lay_solution(course, exercise, home)
    return home


@pytest.fixture
def helpers() -> Iterator[Helpers]:
    with contextlib.closing(Helpers()) as helpers:
        yield helpers


def test_what_is_kept_is_judged_the_same_again(
    exercise: Exercise, home: Path, tmp_path: Path, helpers: Helpers
) -> None:
    evidence = tmp_path / "evidence/02-script.mcap"
    result = attempt_exercise(Request(exercise, home, find_ros(), evidence=evidence), helpers)
    assert result.verdict is Verdict.PASSED and result.timing.evidence > 0
    assert load(evidence).scenario
    assert helpers.judge.judge(exercise, evidence) == Judgment(result.checks)


def test_a_recording_that_cannot_be_kept_is_judged_all_the_same(
    exercise: Exercise, home: Path, tmp_path: Path, helpers: Helpers
) -> None:
    nowhere = tmp_path / "evidence" / ("long" * 100)
    told: list[str] = []
    request = Request(exercise, home, find_ros(), evidence=nowhere, on_progress=told.append)
    assert attempt_exercise(request, helpers).verdict is Verdict.PASSED
    assert any("could not be kept" in text for text in told)


class Blind(Judge):
    """Finds no recording."""

    def judge(self, exercise: Exercise, file: Path) -> Judgment:
        return super().judge(exercise, Path("/nowhere"))


def test_what_cannot_be_judged_is_our_error(exercise: Exercise, home: Path) -> None:
    with contextlib.closing(Helpers()) as helpers:
        helpers.judge = Blind()
        result = attempt_exercise(Request(exercise, home, find_ros()), helpers)
    assert result.verdict is Verdict.OUR_ERROR and result.fault is not None
    assert result.fault.summary == "The recording no longer exists."

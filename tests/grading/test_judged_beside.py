"""A grading whose recording somebody else judges ends as one that judges it itself."""

from __future__ import annotations

import contextlib
from pathlib import Path

import pytest

from course.content import Course, Exercise, open_course
from course.errors import OurFault
from course.grading import trial
from course.grading.channel import Judgement
from course.grading.check import check_exercise
from course.grading.rejudge import Beside
from course.grading.result import CheckResult, Verdict
from course.home import create_home
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


def judged(check: CheckResult) -> tuple[object, ...]:
    """What one run has in common with the next: Ctrl+C need not come upon the same line."""
    told = check.feedback and (check.feedback.summary, check.feedback.expected, check.feedback.advice)
    return check.id, check.outcome, check.points, check.skipped_because, told


def nobody(exercise: Exercise, file: Path) -> Judgement:
    raise OurFault("there is no recording to judge")


@pytest.mark.parametrize(("mistake", "verdict"), [(False, Verdict.PASSED), (True, Verdict.NOT_PASSED)])
def test_the_same_verdict(
    exercise: Exercise, home: Path, tmp_path: Path, mistake: bool, verdict: Verdict
) -> None:
    if mistake:
        trial.apply_mistake(exercise, exercise.mistakes()[0], home)
    evidence = tmp_path / "evidence/02-script.mcap"
    itself = check_exercise(exercise, home, ros=find_ros(), evidence=evidence)
    evidence.unlink()
    with contextlib.closing(Beside()) as beside:
        other = check_exercise(exercise, home, ros=find_ros(), evidence=evidence, judge=beside.judge)
    assert itself.verdict is other.verdict is verdict
    assert [judged(check) for check in other.checks] == [judged(check) for check in itself.checks]
    assert other.timing.evidence > 0


def test_a_recording_that_cannot_be_kept_is_judged_all_the_same(
    exercise: Exercise, home: Path, tmp_path: Path
) -> None:
    nowhere = tmp_path / "evidence" / ("long" * 100)
    told: list[str] = []
    result = check_exercise(
        exercise, home, ros=find_ros(), evidence=nowhere, judge=nobody, on_progress=told.append
    )
    assert result.verdict is Verdict.PASSED
    assert any("could not be kept" in text for text in told)


def test_what_the_judge_cannot_judge_is_our_error(exercise: Exercise, home: Path, tmp_path: Path) -> None:
    def thief(exercise: Exercise, file: Path) -> Judgement:
        file.unlink()
        return beside.judge(exercise, file)

    with contextlib.closing(Beside()) as beside:
        evidence = tmp_path / "evidence/02-script.mcap"
        result = check_exercise(exercise, home, ros=find_ros(), evidence=evidence, judge=thief)
    assert result.verdict is Verdict.OUR_ERROR
    assert result.fault is not None
    assert result.fault.summary == "The recording is not there any more."

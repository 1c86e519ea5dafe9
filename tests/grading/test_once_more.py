"""Anything that may not be the learner's failure is watched again, and the last attempt counts."""

from __future__ import annotations

import contextlib
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import IO

import pytest

from course.content import Exercise, open_course
from course.errors import MissingHere
from course.grading import check as module
from course.grading.author import CheckSpec
from course.grading.check import Request, check_exercise
from course.grading.load import load_grader
from course.grading.outcomes import failed, passed, raised
from course.grading.protocol import Judgment, RecordingOutcome
from course.model import replace
from course.model.feedback import Feedback, Spoilt
from course.model.result import Doubt, Verdict
from course.rosenv import find_ros

SPEC = CheckSpec("interrupt", "Ctrl+C ends it", 1, False, (), "02-script")
RECORDED = RecordingOutcome(1.0)
DIED = RecordingOutcome(fault=Feedback("The recording process died."), doubt=Doubt.SPOILT)
# What was recorded, and what is said of it.
Attempt = tuple[RecordingOutcome, Judgment | None]
SPOILT: Attempt = (RECORDED, Judgment((raised(SPEC, Spoilt("rclpy fell over.")),)))
RIGHT: Attempt = (RECORDED, Judgment((passed(SPEC),)))
WRONG: Attempt = (RECORDED, Judgment((failed(SPEC, Feedback("it goes on")),)))
LATE: Attempt = (replace(RECORDED, lag=0.5), WRONG[1])
LOST: Attempt = (DIED, None)


@pytest.fixture
def exercise() -> Exercise:
    return replace(open_course().exercise("02-script"), packages=(), grader_packages=())


def pretend(monkeypatch: pytest.MonkeyPatch, attempts: list[Attempt]) -> list[Attempt]:
    """Use these instead of the processes' own; return those that were requested so far."""
    made: list[Attempt] = []

    class Recorder:
        recording: IO[bytes]

        def record(self, *_: object) -> RecordingOutcome:
            made.append(attempts[len(made)])
            return made[-1][0]

    class Judge:
        def prepare(self, *_: object) -> None: ...
        def close(self) -> None: ...

        def judge(self, *_: object) -> Judgment:
            assert made[-1][1] is not None
            return made[-1][1]

    @contextlib.contextmanager
    def supervisor(*_: object, **__: object) -> Iterator[Recorder]:
        recorder = Recorder()
        with tempfile.TemporaryFile() as recorder.recording:
            yield recorder

    monkeypatch.setattr(module, "Supervisor", supervisor)
    monkeypatch.setattr(module, "Judge", Judge)
    return made


def test_what_this_machine_lacks_is_said_with_its_remedy(
    exercise: Exercise, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    lacking = RecordingOutcome(fault=Feedback("no g++", advice="install it"), missing=True)
    pretend(monkeypatch, [(lacking, None)])
    with pytest.raises(MissingHere) as caught:
        check_exercise(Request(exercise, tmp_path, ros=find_ros(), namespaces=False))
    assert (caught.value.what, caught.value.next_step) == ("no g++", "install it")


@pytest.mark.parametrize(
    ("attempts", "verdict"),
    [
        ([RIGHT], Verdict.PASSED),
        ([WRONG], Verdict.NOT_PASSED),
        ([SPOILT, RIGHT], Verdict.PASSED),
        ([LATE, SPOILT, WRONG], Verdict.NOT_PASSED),
        ([SPOILT, SPOILT, SPOILT, RIGHT], Verdict.NOT_PASSED),  # the last is the course's own solution
        ([SPOILT, SPOILT, SPOILT, SPOILT], Verdict.OUR_ERROR),
        ([LOST, LOST, LOST, RIGHT], Verdict.NOT_PASSED),
        ([LOST, LOST, LOST, LOST], Verdict.OUR_ERROR),
        ([LATE, LATE, LATE], Verdict.OUR_ERROR),
    ],
)
def test_again(
    exercise: Exercise,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    attempts: list[Attempt],
    verdict: Verdict,
) -> None:
    made = pretend(monkeypatch, attempts)
    result = check_exercise(Request(exercise, tmp_path, ros=find_ros(), namespaces=False))
    assert (result.verdict, made) == (verdict, attempts)
    every = load_grader(exercise.grader, exercise.id).checks
    if attempts[0] is LOST and verdict is Verdict.NOT_PASSED:  # it is blamed
        assert len(result.checks) == len(every)
    else:
        judgment = attempts[-1][1]
        assert len(result.checks) == (len(judgment.checks) if judgment else 0)

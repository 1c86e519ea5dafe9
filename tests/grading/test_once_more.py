"""A recording that was spoilt by somebody else's fault is made once more, and once only."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from course.content import Exercise, open_course
from course.errors import MissingHere
from course.feedback import Feedback, Spoilt
from course.grading import check as module
from course.grading.author import CheckSpec
from course.grading.channel import Judgement
from course.grading.check import check_exercise
from course.grading.outcome import passed, raised
from course.grading.result import Verdict
from course.rosenv import find_ros

SPEC = CheckSpec("interrupt", "Ctrl+C ends it", 1, False, (), "02-script")
SPOILT = Judgement((raised(SPEC, Spoilt("rclpy fell over.")),), 1.0)
RIGHT = Judgement((passed(SPEC),), 1.0)


@pytest.fixture
def exercise() -> Exercise:
    return replace(open_course().exercise("02-script"), packages=(), grader_packages=())


def given_by_supervisor(monkeypatch: pytest.MonkeyPatch, judgements: list[Judgement]) -> list[Judgement]:
    """These judgements in place of grading processes' own; returns those that were asked for by now."""
    given: list[Judgement] = []

    class Made:
        def grade(self, *_: object) -> Judgement:
            given.append(judgements[len(given)])
            return given[-1]

    @contextlib.contextmanager
    def supervisor(*_: object) -> Iterator[Made]:
        yield Made()

    monkeypatch.setattr(module, "Supervisor", supervisor)
    return given


def test_what_this_machine_lacks_is_said_with_its_remedy(
    exercise: Exercise, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    lacking = Judgement((), 0.0, Feedback("no g++", advice="install it"), missing=True)
    given_by_supervisor(monkeypatch, [lacking])
    with pytest.raises(MissingHere) as caught:
        check_exercise(exercise, tmp_path, ros=find_ros(), namespaces=False)
    assert (caught.value.what, caught.value.next_step) == ("no g++", "install it")


@pytest.mark.parametrize(
    ("judgements", "verdict", "tries"),
    [
        ([SPOILT, RIGHT], Verdict.PASSED, 2),
        ([SPOILT, SPOILT, RIGHT], Verdict.OUR_ERROR, 2),
        ([RIGHT, SPOILT], Verdict.PASSED, 1),
    ],
)
def test_once_more(
    exercise: Exercise,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    judgements: list[Judgement],
    verdict: Verdict,
    tries: int,
) -> None:
    given = given_by_supervisor(monkeypatch, judgements)
    result = check_exercise(exercise, tmp_path, ros=find_ros(), namespaces=False)
    assert (result.verdict, len(given)) == (verdict, tries)

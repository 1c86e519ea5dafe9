"""One task: our faults and loaded machines are never the learner's, and a busy submission is its own."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.batch import one
from course.batch.model import Task, Unit
from course.errors import MissingHere
from course.grading.result import Outcome, Result, Verdict
from course.home import create_home
from course.home.model import read_marker
from tests.batch.samples import FAILED, PASSED, QUIZ, lagging
from tests.conftest import FIXTURES

QUIZ_COURSE = FIXTURES / "quiz_course"


def task(*, contained: bool = True, person: str = "ada", exercise: str = QUIZ) -> Task:
    return Task(Unit(person, exercise), "home", "evidence.mcap", str(QUIZ_COURSE), contained)


def answering(monkeypatch: pytest.MonkeyPatch, answer: Result | Exception) -> None:
    def check(*_: object, **__: object) -> Result:
        if isinstance(answer, Exception):
            raise answer
        return answer

    monkeypatch.setattr(one, "check_exercise", check)


@pytest.mark.parametrize(
    ("verdict", "lag", "cpu", "ours"),
    [
        (Verdict.NOT_PASSED, 0.3, 0.2, True),
        (Verdict.NOT_PASSED, 0.05, 0.2, False),
        (Verdict.NOT_PASSED, 0.3, 3.0, False),  # it kept the machine busy itself
        (Verdict.PASSED, 0.3, 0.2, False),
    ],
)
def test_a_loaded_machine_marks_nothing_as_wrong(
    monkeypatch: pytest.MonkeyPatch, verdict: Verdict, lag: float, cpu: float, ours: bool
) -> None:
    answering(monkeypatch, lagging(verdict, lag, cpu))
    result = one.grade(task(), Path())
    assert result.verdict is (Verdict.OUR_ERROR if ours else verdict)
    assert bool(result.fault) is ours
    if result.fault:
        assert "too busy to judge" in result.fault.summary
        assert result.timing.lag == lag


def test_what_this_machine_lacks_is_our_error(monkeypatch: pytest.MonkeyPatch) -> None:
    answering(monkeypatch, MissingHere("There is no compiler.", "Install one."))
    result = one.grade(task(), Path())
    assert result.verdict is Verdict.OUR_ERROR
    assert result.fault and (result.fault.summary, result.fault.advice) == (
        "There is no compiler.",
        "Install one.",
    )


def test_a_bug_of_ours_is_our_error(monkeypatch: pytest.MonkeyPatch) -> None:
    answering(monkeypatch, ZeroDivisionError("division by zero"))
    result = one.grade(task(), Path())
    assert result.verdict is Verdict.OUR_ERROR
    assert result.fault


def test_an_exercise_that_is_not_there_is_our_error() -> None:
    assert one.grade(task(exercise="99-none"), Path()).verdict is Verdict.OUR_ERROR


@pytest.mark.parametrize("where", ["namespaces", "domain"])
def test_what_was_not_contained_does_not_count(monkeypatch: pytest.MonkeyPatch, where: str) -> None:
    result = Result("04-light", Verdict.PASSED, PASSED.checks, containment=where, notes=("no bubblewrap",))
    answering(monkeypatch, result)
    refused = one.grade(task(), Path())
    assert refused.verdict is Verdict.OUR_ERROR
    assert refused.fault and "no bubblewrap" in refused.fault.summary
    assert one.grade(task(contained=False), Path()) == result


def test_what_runs_nothing_needs_no_containment(tmp_path: Path) -> None:
    result = one.grade(task(), tmp_path)
    assert result.verdict is Verdict.NOT_PASSED
    assert result.containment == ""
    assert not any(check.outcome is Outcome.PASSED for check in result.checks)


def test_a_contained_result_is_kept_as_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    answering(monkeypatch, FAILED)
    assert one.grade(task(), Path()) == FAILED


def test_the_seed_is_the_learners_own(tmp_path: Path) -> None:
    create_home(tmp_path / "home")
    assert one.seed_of(task(), tmp_path / "home") == read_marker(tmp_path / "home")


def test_without_a_course_home_the_seed_is_the_persons(tmp_path: Path) -> None:
    assert one.seed_of(task(), tmp_path) == one.seed_of(task(), tmp_path / "other")
    assert one.seed_of(task(), tmp_path) != one.seed_of(task(person="bao"), tmp_path)


def test_a_damaged_course_home_has_the_persons_seed(tmp_path: Path) -> None:
    (tmp_path / ".ros2course").mkdir()
    (tmp_path / ".ros2course/home.json").write_text('{"seed": "much"}')
    assert one.seed_of(task(), tmp_path) == one.seed_of(task(), tmp_path / "none")

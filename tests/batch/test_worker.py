"""One task: our errors and busy machines are never the learner's fault."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.batch import worker
from course.batch.gradings import GradingTask, Unit
from course.errors import MissingHere
from course.grading.attempts import ATTEMPTS, deserves_another
from course.grading.check import Helpers
from course.home import create_home
from course.home.course_home import read_marker
from course.model.result import Outcome, Result, Verdict
from tests.batch.samples import FAILED, PASSED, QUIZ, lagging
from tests.conftest import FIXTURES

NOBODY = Helpers()  # starts no process before there is something to judge
QUIZ_COURSE = FIXTURES / "quiz_course"


def task(
    *, contained: bool = True, person: str = "ada", exercise: str = QUIZ, attempt: int = 1
) -> GradingTask:
    return GradingTask(Unit(person, exercise, attempt), "home", "evidence.mcap", str(QUIZ_COURSE), contained)


def answering(monkeypatch: pytest.MonkeyPatch, answer: Result | Exception) -> None:
    def check(*_: object, **__: object) -> Result:
        if isinstance(answer, Exception):
            raise answer
        return answer

    monkeypatch.setattr(worker, "attempt_exercise", check)


@pytest.mark.parametrize("attempt", [1, ATTEMPTS])
@pytest.mark.parametrize(
    ("verdict", "lag", "ours"),
    [(Verdict.NOT_PASSED, 0.3, True), (Verdict.NOT_PASSED, 0.05, False), (Verdict.PASSED, 0.3, False)],
)
def test_a_loaded_machine_marks_nothing_as_wrong(
    monkeypatch: pytest.MonkeyPatch, verdict: Verdict, lag: float, ours: bool, attempt: int
) -> None:
    """Earlier attempts are reported as they were; the scheduler asks for another one."""
    answering(monkeypatch, lagging(verdict, lag))
    result = worker.grade(task(attempt=attempt), Path(), NOBODY)
    assert deserves_another(result, 1) is ours
    assert result.verdict is (Verdict.OUR_ERROR if ours and attempt == ATTEMPTS else verdict)
    if result.fault:
        assert "too busy to judge" in result.fault.summary
    assert result.timing.lag == lag


def test_what_this_machine_lacks_is_our_error(monkeypatch: pytest.MonkeyPatch) -> None:
    answering(monkeypatch, MissingHere("There is no compiler.", "Install one."))
    result = worker.grade(task(), Path(), NOBODY)
    assert result.verdict is Verdict.OUR_ERROR
    assert result.fault and (result.fault.summary, result.fault.advice) == (
        "There is no compiler.",
        "Install one.",
    )


def test_a_bug_of_ours_is_our_error(monkeypatch: pytest.MonkeyPatch) -> None:
    answering(monkeypatch, ZeroDivisionError("division by zero"))
    result = worker.grade(task(), Path(), NOBODY)
    assert result.verdict is Verdict.OUR_ERROR
    assert result.fault


def test_an_exercise_that_is_not_there_is_our_error() -> None:
    assert worker.grade(task(exercise="99-none"), Path(), NOBODY).verdict is Verdict.OUR_ERROR


@pytest.mark.parametrize("where", ["namespaces", "domain"])
def test_what_was_not_contained_does_not_count(monkeypatch: pytest.MonkeyPatch, where: str) -> None:
    result = Result("04-light", Verdict.PASSED, PASSED.checks, containment=where, notes=("no bubblewrap",))
    answering(monkeypatch, result)
    refused = worker.grade(task(), Path(), NOBODY)
    assert refused.verdict is Verdict.OUR_ERROR
    assert refused.fault and "no bubblewrap" in refused.fault.summary
    assert worker.grade(task(contained=False), Path(), NOBODY) == result


def test_what_runs_nothing_needs_no_containment(tmp_path: Path) -> None:
    result = worker.grade(task(), tmp_path, NOBODY)
    assert result.verdict is Verdict.NOT_PASSED
    assert result.containment == ""
    assert not any(check.outcome is Outcome.PASSED for check in result.checks)


def test_a_contained_result_is_kept_as_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    answering(monkeypatch, FAILED)
    assert worker.grade(task(), Path(), NOBODY) == FAILED


def test_the_seed_is_the_learners_own(tmp_path: Path) -> None:
    create_home(tmp_path / "home")
    assert worker.seed_of(task(), tmp_path / "home") == read_marker(tmp_path / "home")


def test_without_a_course_home_the_seed_is_the_persons(tmp_path: Path) -> None:
    assert worker.seed_of(task(), tmp_path) == worker.seed_of(task(), tmp_path / "other")
    assert worker.seed_of(task(), tmp_path) != worker.seed_of(task(person="bao"), tmp_path)


def test_a_damaged_course_home_has_the_persons_seed(tmp_path: Path) -> None:
    (tmp_path / ".ros2course").mkdir()
    (tmp_path / ".ros2course/home.json").write_text('{"seed": "much"}')
    assert worker.seed_of(task(), tmp_path) == worker.seed_of(task(), tmp_path / "none")

"""What newly passed, what newly failed, and how the points changed."""

from __future__ import annotations

from course.model.result import CheckResult, Outcome, Result, Verdict
from course.watch.updates import ResultChange, what_changed

P, F, S = Outcome.PASSED, Outcome.FAILED, Outcome.SKIPPED


def result(exercise: str = "04-light", **outcomes: Outcome) -> Result:
    checks = tuple(CheckResult(name, f"It {name}", 2, outcome) for name, outcome in outcomes.items())
    return Result(exercise, Verdict.NOT_PASSED, checks)


def test_newly_passed_and_newly_failed() -> None:
    change = what_changed(result(a=P, b=F, c=F, d=P), result(a=F, b=P, c=P, d=P))
    assert change == ResultChange(fixed=("It b", "It c"), broken=("It a",), points=2)


def test_what_is_not_judged_any_more_is_lost_and_back_again_won() -> None:
    assert what_changed(result(a=P), result(a=S)) == ResultChange((), ("It a",), -2)
    assert what_changed(result(a=S), result(a=P)) == ResultChange(("It a",), (), 2)


def test_nothing() -> None:
    change = what_changed(result(a=P, b=F), result(a=P, b=S))
    assert change is not None and change.is_nothing


def test_the_first_time_and_another_exercise_cannot_be_compared() -> None:
    assert what_changed(None, result(a=P)) is None
    assert what_changed(result("04-dim", a=P), result(a=P)) is None


def test_checks_of_another_version_are_left_out() -> None:
    assert what_changed(result(a=P, old=P), result(a=P, new=P)) == ResultChange((), (), 0)

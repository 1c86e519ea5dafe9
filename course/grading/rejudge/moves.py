"""What is different between two results of the same submission, check by check, and why."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum

from course.grading.result import CheckResult, Outcome, Result

_WHY = 200


class Change(str, Enum):
    """What made the marks move. GRADER: nothing could be judged, now or before."""

    ADDED = "check added"
    GONE = "check gone"
    OUTCOME = "outcome"
    POINTS = "points"
    GRADER = "grader"


@dataclass(frozen=True)
class Move:
    """One check that brings other points than before, or other points can be had for.

    check: its id; empty when it is about the whole exercise. before, after: points earned. most_before,
    most_after: points that could be had (0 for a bonus check, and where the check was not applicable or
    not there). why: one line.
    """

    check: str
    title: str
    change: Change
    before: float
    after: float
    most_before: float
    most_after: float
    why: str


def moves(before: Result, after: Result) -> tuple[Move, ...]:
    """How the marks moved from one result to the other; in the order of the checks, those gone at the end.

    A check whose feedback alone is another one has not moved.
    """
    old = {check.id: check for check in before.checks}
    new = {check.id: check for check in after.checks}
    return (
        *_of_the_grader(before, after),
        *(move for check in after.checks for move in _of_a_check(old.get(check.id), check)),
        *(move for check in before.checks if check.id not in new for move in _of_a_check(check, None)),
    )


def _of_the_grader(before: Result, after: Result) -> Iterator[Move]:
    if (before.fault is None) is (after.fault is None):
        return
    why = f"could not be judged: {after.fault.summary}" if after.fault else "could not be judged before"
    yield Move(
        "",
        "the exercise",
        Change.GRADER,
        before.points,
        after.points,
        before.max_points,
        after.max_points,
        _line(why),
    )


def _of_a_check(old: CheckResult | None, new: CheckResult | None) -> Iterator[Move]:
    change, why = _why(old, new)
    one = new or old
    if change is not None and one is not None:
        yield Move(
            one.id,
            one.title,
            change,
            old.earned if old else 0.0,
            new.earned if new else 0.0,
            _most(old),
            _most(new),
            _line(why),
        )


def _why(old: CheckResult | None, new: CheckResult | None) -> tuple[Change | None, str]:
    if new is None:
        return Change.GONE, "this check is gone"
    if old is None:
        return Change.ADDED, f"new check: {_said(new)}"
    if old.outcome is not new.outcome:
        points = f" ({_points(old, new)})" if _worth(old) != _worth(new) else ""
        return Change.OUTCOME, f"{old.outcome.value} → {_said(new)}{points}"
    if _worth(old) != _worth(new):
        return Change.POINTS, _points(old, new)
    return None, ""


def _said(check: CheckResult) -> str:
    """The outcome, and what it was because of."""
    because = check.feedback.summary if check.feedback else check.skipped_because
    told = because and check.outcome is not Outcome.PASSED
    return f"{check.outcome.value}: {because}" if told else check.outcome.value


def _worth(check: CheckResult) -> tuple[float, bool]:
    return check.points, check.bonus


def _points(old: CheckResult, new: CheckResult) -> str:
    return f"worth {_amount(new)}, was {_amount(old)}"


def _amount(check: CheckResult) -> str:
    return f"{check.points:g}{' as a bonus' if check.bonus else ''}"


def _most(check: CheckResult | None) -> float:
    if check is None or check.bonus or check.outcome is Outcome.NOT_APPLICABLE:
        return 0.0
    return check.points


def _line(text: str) -> str:
    line = " ".join(text.split())
    return line if len(line) <= _WHY else f"{line[: _WHY - 1]}…"

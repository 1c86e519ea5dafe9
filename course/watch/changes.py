"""What is different between two results of the same exercise."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from course.grading.result import CheckResult, Outcome, Result


@dataclass(frozen=True)
class Change:
    """fixed: titles of checks that pass now and did not; broken: the other way round.

    points: how many more there are, or fewer.
    """

    fixed: tuple[str, ...]
    broken: tuple[str, ...]
    points: float

    @property
    def is_nothing(self) -> bool:
        return not (self.fixed or self.broken or self.points)


def what_changed(before: Result | None, now: Result) -> Change | None:
    """None when there is nothing to compare with. Checks that only one of the two has are left out."""
    if before is None or before.exercise != now.exercise:
        return None
    passed = {check.id: check.outcome is Outcome.PASSED for check in before.checks}
    known = [check for check in now.checks if check.id in passed]
    return Change(
        fixed=_titles(check for check in known if _passes(check) and not passed[check.id]),
        broken=_titles(check for check in known if not _passes(check) and passed[check.id]),
        points=now.points - before.points,
    )


def _passes(check: CheckResult) -> bool:
    return check.outcome is Outcome.PASSED


def _titles(checks: Iterable[CheckResult]) -> tuple[str, ...]:
    return tuple(check.title for check in checks)

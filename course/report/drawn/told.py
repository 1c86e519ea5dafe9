"""What the checks expected, put beside what is drawn."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from course.feedback import Pace
from course.grading.result import CheckResult, Outcome, Result
from course.report.pictures.lanes import Lane

_NAME = re.compile(r"/\w[\w/]*")


@dataclass(frozen=True)
class Told:
    """What a result says of its recording: checks that did not pass, and how often messages were to come."""

    failed: tuple[CheckResult, ...] = ()
    paces: tuple[Pace, ...] = ()

    @classmethod
    def by(cls, result: Result | None) -> Told:
        checks = result.checks if result else ()
        failed = tuple(check for check in checks if check.outcome is Outcome.FAILED and check.feedback)
        return cls(failed, tuple(check.pace for check in checks if check.pace))

    def pace(self, topic: str) -> Pace | None:
        return next((pace for pace in self.paces if pace.topic == topic), None)

    def of(self, lane: Lane) -> tuple[CheckResult, ...]:
        """Checks that name this lane's topic, service or node in what they expected or saw."""
        return tuple(check for check in self.failed if lane.label in _names(check))

    def names(self) -> tuple[str, ...]:
        """Names that were expected and are not what was seen."""
        expected = (check.feedback.expected or "" for check in self.failed if check.feedback)
        return tuple(dict.fromkeys(name for text in expected for name in _NAME.findall(text)))


def _names(check: CheckResult) -> Iterator[str]:
    if check.feedback:
        for text in (check.feedback.expected, check.feedback.seen):
            yield from _NAME.findall(text or "")

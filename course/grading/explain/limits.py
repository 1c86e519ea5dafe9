"""What a check says that did not pass when the programs had used up too much, and were all ended."""

from __future__ import annotations

import dataclasses

from course.evidence.events import LimitReached
from course.feedback import Feedback
from course.grading.result import CheckResult, Outcome

_MB = 1024 * 1024
_WORDS = {
    "memory": (
        "Your programs took more than {mb:.0f} MB of memory, so all of them were stopped.",
        "Look for what grows without end: a list that is added to in a callback, or a loop that makes nodes.",
    ),
    "processes": (
        "Your programs started more than {most:.0f} processes and threads, so all of them were stopped.",
        "Look for what starts programs or threads in a loop or in a callback.",
    ),
    "cpu": (
        "Your programs used {most:.0f} s of computing time, so all of them were stopped.",
        "Look for a loop that never waits.",
    ),
    "disk": (
        "Your programs wrote more than {mb:.0f} MB of files, so all of them were stopped.",
        "Look for what writes files in a loop or in a callback.",
    ),
}


def with_limit(result: CheckResult, reached: LimitReached | None) -> CheckResult:
    """The result, with the limit as its cause where it is none but a failure; also where a check of ours

    found evidence that ends in the middle and could make nothing of it.
    """
    if reached is None or result.outcome not in (Outcome.FAILED, Outcome.ERROR):
        return result
    found = result.feedback.summary if result.feedback and result.outcome is Outcome.FAILED else None
    return dataclasses.replace(result, outcome=Outcome.FAILED, feedback=feedback_of(reached, found))


def feedback_of(reached: LimitReached, found: str | None = None) -> Feedback:
    """found: what a check saw because of it."""
    summary, advice = _WORDS[reached.limit]
    words = summary.format(most=reached.most, mb=reached.most / _MB)
    return Feedback(summary=words, advice=advice, details=(found,) if found else ())

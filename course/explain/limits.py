"""Feedback on checks that did not pass because the programs exceeded a limit and were all stopped."""

from __future__ import annotations

from course.model import replace
from course.model.events import LimitReached
from course.model.feedback import Feedback
from course.model.result import CheckResult, Outcome

_MB = 1024 * 1024
_WORDS = {
    "memory": (
        "Your programs took more than {mb:.0f} MB of memory, so all of them were stopped.",
        "Look for something that grows forever: a list that a callback appends to, or a loop "
        "that creates nodes.",
    ),
    "processes": (
        "Your programs started more than {most:.0f} processes and threads, so all of them were stopped.",
        "Look for code that starts programs or threads in a loop or in a callback.",
    ),
    "cpu": (
        "Your programs used {most:.0f} s of CPU time, so all of them were stopped.",
        "Look for a loop that never waits.",
    ),
    "disk": (
        "Your programs wrote more than {mb:.0f} MB of files, so all of them were stopped.",
        "Look for code that writes files in a loop or in a callback.",
    ),
}


def with_limit(result: CheckResult, reached: LimitReached | None) -> CheckResult:
    """The result; it names the limit as the cause if the check failed or could not judge the evidence."""
    if reached is None or result.outcome not in (Outcome.FAILED, Outcome.ERROR):
        return result
    found = result.feedback.summary if result.feedback and result.outcome is Outcome.FAILED else None
    return replace(result, outcome=Outcome.FAILED, feedback=feedback_of(reached, found))


def feedback_of(reached: LimitReached, found: str | None = None) -> Feedback:
    """found: what a check saw as a consequence."""
    summary, advice = _WORDS[reached.limit]
    words = summary.format(most=reached.most, mb=reached.most / _MB)
    return Feedback(summary=words, advice=advice, details=(found,) if found else ())

"""A check that did not pass because a limit was reached says so."""

from __future__ import annotations

import pytest

from course.explain.limits import with_limit
from course.model.events import LimitReached
from course.model.feedback import Feedback
from course.model.result import CheckResult, Outcome

MB = 1024 * 1024
SAW = Feedback(summary="No message arrived.")


def check(outcome: Outcome, feedback: Feedback | None = None) -> CheckResult:
    return CheckResult("rate", "publishes", 1, outcome, feedback=feedback)


@pytest.mark.parametrize(
    ("limit", "most", "words"),
    [
        ("memory", 1024 * MB, "took more than 1024 MB of memory"),
        ("processes", 512, "started more than 512 processes and threads"),
        ("cpu", 120.0, "used 120 s of CPU time"),
        ("disk", 256 * MB, "wrote more than 256 MB of files"),
    ],
)
def test_each_limit_has_its_words(limit: str, most: float, words: str) -> None:
    found = with_limit(check(Outcome.FAILED, SAW), LimitReached(1.0, limit, most))
    assert found.outcome is Outcome.FAILED
    assert found.feedback is not None
    assert words in found.feedback.summary
    assert "Look for" in (found.feedback.advice or "")
    assert found.feedback.details == ("No message arrived.",)


def test_a_check_of_ours_that_broke_on_half_a_recording_is_no_error_of_ours() -> None:
    broken = check(Outcome.ERROR, Feedback(summary="IndexError", details=("a trace of ours",)))
    found = with_limit(broken, LimitReached(1.0, "memory", 1024 * MB))
    assert found.outcome is Outcome.FAILED
    assert found.feedback is not None
    assert found.feedback.details == ()


@pytest.mark.parametrize("outcome", [Outcome.PASSED, Outcome.SKIPPED, Outcome.NOT_APPLICABLE])
def test_what_was_earned_or_not_judged_stays(outcome: Outcome) -> None:
    assert with_limit(check(outcome), LimitReached(1.0, "cpu", 120.0)) == check(outcome)


def test_without_a_limit_nothing_changes() -> None:
    assert with_limit(check(Outcome.FAILED, SAW), None) == check(Outcome.FAILED, SAW)
    assert with_limit(check(Outcome.ERROR, SAW), None).outcome is Outcome.ERROR

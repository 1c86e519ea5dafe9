"""Whose fault it is: only a `Failure` is the learner's."""

from __future__ import annotations

import pytest

from course.errors import OurFault
from course.evidence.recording import Recording
from course.grading.author import CheckSpec
from course.grading.outcomes import doubted, our_error, out_of_reach, passed, raised, skipped, unmet
from course.model.events import Probed
from course.model.feedback import Failure, Feedback, NotApplicable, Spoilt, TooBusy
from course.model.result import CheckResult, Doubt, Outcome

SPEC = CheckSpec("rate", "it is quick", 2, True, ("builds", "starts"), "01-toy")
FEEDBACK = Feedback("it is slow")


def test_passed_and_skipped() -> None:
    assert passed(SPEC) == CheckResult("rate", "it is quick", 2, Outcome.PASSED, True)
    assert skipped(SPEC, 'needs "it starts"') == CheckResult(
        "rate", "it is quick", 2, Outcome.SKIPPED, True, None, 'needs "it starts"'
    )


def test_a_failure_is_the_learners() -> None:
    found = raised(SPEC, Failure(FEEDBACK))
    assert (found.outcome, found.feedback, found.bonus) == (Outcome.FAILED, FEEDBACK, True)


@pytest.mark.parametrize(
    "error", [ValueError("x"), AssertionError(), OurFault("x"), KeyboardInterrupt(), SystemExit(1)]
)
def test_anything_else_is_ours(error: BaseException) -> None:
    found = raised(SPEC, error)
    assert found.outcome is Outcome.ERROR
    assert found.feedback is not None
    assert type(error).__name__ in found.feedback.summary
    assert "not yours" in str(found.feedback.advice)


@pytest.mark.parametrize(
    ("error", "doubt"),
    [
        (Spoilt("rclpy fell over."), Doubt.SPOILT),
        (TooBusy("rclpy fell over."), Doubt.BUSY),
        (MemoryError("rclpy fell over."), Doubt.SPOILT),
        (OurFault("rclpy fell over."), Doubt.SPOILT),
        (ValueError("rclpy fell over."), None),
    ],
)
def test_another_attempt_may_end_differently(error: BaseException, doubt: Doubt | None) -> None:
    found = raised(SPEC, error)
    assert (found.outcome, found.doubt) == (Outcome.ERROR, doubt)
    assert found.feedback is not None
    assert "rclpy fell over." in found.feedback.summary
    assert raised(SPEC, Failure(FEEDBACK)).doubt is None


@pytest.mark.parametrize(("events", "doubt"), [((), None), ((Probed(1.0, "probe", (), True),), Doubt.SPOILT)])
def test_what_a_probe_was_answered_may_break_a_check(events: tuple[Probed, ...], doubt: Doubt | None) -> None:
    """The learner's code runs in the same process, and can answer anything."""
    recording = Recording("01-toy", events)
    assert doubted(raised(SPEC, TypeError("x")), recording).doubt is doubt
    busy = raised(SPEC, TooBusy("x"))
    for other in (busy, passed(SPEC), raised(SPEC, Failure(FEEDBACK))):
        assert doubted(other, recording) == other


def test_our_error_tells_where_it_was_in_a_few_lines() -> None:
    def deep(depth: int) -> None:
        if depth:
            deep(depth - 1)
        raise ValueError("first line\nsecond line")

    try:
        deep(100)
    except ValueError as error:
        found = our_error(error)
    assert found.summary == "The grader itself failed here (ValueError: first line)."
    assert found.details[-1] == "second line"
    assert len(found.details) <= 12


def test_our_error_without_words() -> None:
    assert our_error(ValueError()).summary == "The grader itself failed here (ValueError: )."


def result(name: str, outcome: Outcome) -> CheckResult:
    return CheckResult(name, name, 1, outcome)


@pytest.mark.parametrize("outcome", [Outcome.FAILED, Outcome.SKIPPED, Outcome.ERROR])
def test_what_a_check_needs_must_have_passed(outcome: Outcome) -> None:
    titles = {"builds": "the packages build", "starts": "it starts"}
    done = {"builds": result("builds", Outcome.PASSED), "starts": result("starts", outcome)}
    assert unmet(SPEC, done, titles) == 'needs "it starts"'
    done["builds"] = result("builds", outcome)
    assert unmet(SPEC, done, titles) == 'needs "the packages build"'


def test_all_needs_are_met() -> None:
    done = {name: result(name, Outcome.PASSED) for name in SPEC.needs}
    assert unmet(SPEC, done, {}) is None


def test_what_cannot_be_judged_here_is_nobodys_fault() -> None:
    found = raised(SPEC, NotApplicable("No package index can be reached."))
    assert (found.outcome, found.earned) == (Outcome.NOT_APPLICABLE, 0)
    assert found.skipped_because == "No package index can be reached."
    assert found.feedback is None


def test_what_needs_it_cannot_be_judged_either() -> None:
    gone = CheckResult("starts", "starts", 1, Outcome.NOT_APPLICABLE, skipped_because="no index")
    assert out_of_reach(SPEC, {"builds": result("builds", Outcome.PASSED), "starts": gone}) == "no index"
    assert out_of_reach(SPEC, {name: result(name, Outcome.FAILED) for name in SPEC.needs}) is None

"""Whose marks changed, and why."""

from __future__ import annotations

import pytest

from course.grading.judge.regraded import Move, MoveCause, moves
from course.model import replace
from course.model.feedback import Feedback
from course.model.result import CheckResult, Outcome, Result, Verdict

PASSED = CheckResult("a", "does a", 2, Outcome.PASSED)
FAILED = replace(PASSED, outcome=Outcome.FAILED, feedback=Feedback("It does\nno  a."))
SKIPPED = replace(PASSED, outcome=Outcome.SKIPPED, skipped_because='needs "b"')
ABSENT = replace(PASSED, outcome=Outcome.NOT_APPLICABLE, skipped_because="no camera here")


def result(*checks: CheckResult, fault: Feedback | None = None) -> Result:
    return Result("18-x", Verdict.PASSED, checks, fault=fault)


@pytest.mark.parametrize(
    ("before", "after", "move"),
    [
        (
            PASSED,
            FAILED,
            Move("a", "does a", MoveCause.OUTCOME, 2, 0, 2, 2, "passed → failed: It does no a."),
        ),
        (FAILED, PASSED, Move("a", "does a", MoveCause.OUTCOME, 0, 2, 2, 2, "failed → passed")),
        (
            FAILED,
            replace(PASSED, points=5),
            Move("a", "does a", MoveCause.OUTCOME, 0, 5, 2, 5, "failed → passed (worth 5, was 2)"),
        ),
        (PASSED, SKIPPED, Move("a", "does a", MoveCause.OUTCOME, 2, 0, 2, 2, 'passed → skipped: needs "b"')),
        (
            PASSED,
            ABSENT,
            Move("a", "does a", MoveCause.OUTCOME, 2, 0, 2, 0, "passed → not applicable: no camera here"),
        ),
        (
            PASSED,
            replace(PASSED, points=1.5),
            Move("a", "does a", MoveCause.POINTS, 2, 1.5, 2, 1.5, "worth 1.5, was 2"),
        ),
        (
            FAILED,
            replace(FAILED, bonus=True),
            Move("a", "does a", MoveCause.POINTS, 0, 0, 2, 0, "worth 2 as a bonus, was 2"),
        ),
        (None, FAILED, Move("a", "does a", MoveCause.ADDED, 0, 0, 0, 2, "new check: failed: It does no a.")),
        (None, PASSED, Move("a", "does a", MoveCause.ADDED, 0, 2, 0, 2, "new check: passed")),
        (PASSED, None, Move("a", "does a", MoveCause.GONE, 2, 0, 2, 0, "this check was removed")),
    ],
)
def test_a_check_that_moved(before: CheckResult | None, after: CheckResult | None, move: Move) -> None:
    other = replace(PASSED, id="other")
    old = result(other, *([before] if before else []))
    new = result(*([after] if after else []), other)
    assert moves(old, new) == (move,)
    assert new.points - old.points == move.after - move.before
    assert new.max_points - old.max_points == move.most_after - move.most_before


def test_other_words_are_no_move() -> None:
    assert moves(result(FAILED), result(replace(FAILED, feedback=Feedback("Otherwise."), title="A!"))) == ()


def test_a_fault_of_the_grader_comes_first() -> None:
    broken = result(fault=Feedback("The grader cannot be run."))
    first, second = moves(result(PASSED), broken)
    assert (first.check, first.cause, first.why) == (
        "",
        MoveCause.GRADER,
        "could not be judged: The grader cannot be run.",
    )
    assert (first.before, first.after) == (2, 0)
    assert second.cause is MoveCause.GONE
    assert moves(broken, result(PASSED))[0].why == "could not be judged before"
    assert moves(broken, broken) == ()


def test_why_stays_one_short_line() -> None:
    endless = replace(FAILED, feedback=Feedback("word\n" * 500))
    (move,) = moves(result(PASSED), result(endless))
    assert len(move.why) <= 200
    assert "\n" not in move.why

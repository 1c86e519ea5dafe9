"""A check in words, for every format that shows texts; those of the terminal, where it has them."""

from __future__ import annotations

from collections.abc import Iterator

from course.grading.result import CheckResult, Feedback, Outcome
from course.report.console import number
from course.report.gradebook.sheets import NOT_HANDED_IN, Mark, Sheet
from course.report.terminal import HEADLINES, LABEL_WIDTH, MARKS, comparison, earned_of, total_of

NOTHING = "Nothing was handed in for this exercise."


def mark_of(check: CheckResult) -> str:
    """`ok`, `no`, `--`, `..` or `!!`, as beside a check on the terminal."""
    return MARKS[check.outcome][0]


def points_of(check: CheckResult) -> str:
    """`2`, `0 of 2`, `bonus 0.5`; empty where the check does not apply."""
    return earned_of(check)


def headline(mark: Mark) -> str:
    """The verdict on an exercise, without its points: `Not passed yet`."""
    return HEADLINES[mark.result.verdict][0] if mark.result else NOT_HANDED_IN.capitalize()


def total(mark: Mark) -> str:
    """`5 of 12 points`; empty where there are none to give."""
    if not mark.counts:
        return ""
    return total_of(mark.result) if mark.result else f"0 of {number(mark.exercise.max_points)} points"


def score(points: float | None, most: float | None) -> str:
    """`5 of 12`, or `-`."""
    return "-" if points is None or most is None else f"{number(points)} of {number(most)}"


def summary(sheet: Sheet) -> str:
    """`5 of 24 points`, or that they are not known yet."""
    if sheet.points is None:
        judged = score(sheet.judged_points, sheet.judged_max)
        return f"not complete: {judged} points so far, and the course owes a verdict"
    return f"{score(sheet.points, sheet.max_points)} points"


def why(check: CheckResult) -> Feedback | None:
    """What there is to say about a check that did not pass."""
    if check.outcome is Outcome.PASSED:
        return None
    cause = check.skipped_because or "the cause is not known"
    if check.outcome is Outcome.SKIPPED:
        return Feedback(f"Not judged: {cause}")
    if check.outcome is Outcome.NOT_APPLICABLE:
        return Feedback(f"Does not count here: {cause}")
    return check.feedback or Feedback("It did not pass.")


def labelled(feedback: Feedback) -> Iterator[tuple[str, str]]:
    """What stands below the cause, each with its label: expected, seen, in (places), try."""
    yield from comparison(feedback)
    yield from (("in", str(place)) for place in feedback.where)
    if feedback.advice:
        yield "try", feedback.advice


def text_of(feedback: Feedback) -> str:
    """All of it as plain text, a line for each part."""
    parts = (f"{label.ljust(LABEL_WIDTH)}{text}" for label, text in labelled(feedback))
    return "\n".join((feedback.summary, *parts, *(f"| {line}" for line in feedback.details)))

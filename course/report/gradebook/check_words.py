"""Results in words, for every format that shows texts; the same words as on the terminal where possible."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from course.model.gradebook import HandMark
from course.model.result import CheckResult, Feedback, Outcome
from course.report.console import number
from course.report.gradebook.sheets import (
    EXCUSED,
    INCOMPLETE,
    MARKED,
    NOT_HANDED_IN,
    Mark,
    Sheet,
    tidy,
)
from course.report.verdict import HEADLINES, LABEL_WIDTH, MARKS, comparison, total_of

NOTHING = "Nothing was handed in for this exercise."
_NOTHING_AT_ALL = "Nothing of yours was found. If you did hand something in, tell your instructor."
_NOTHING_IN_IT = "Nothing that can be graded was found in what you handed in. The note says why."
_OWED = (
    "Something could not be checked, through no fault of yours: see below. "
    "Your points are final once that is done."
)


def mark_of(check: CheckResult) -> str:
    """`ok`, `no`, `--`, `..` or `!!`, as next to a check on the terminal."""
    return MARKS[check.outcome][0]


def headline(mark: Mark) -> str:
    """The verdict on an exercise, without its points: `Not passed yet`."""
    if mark.result is None or mark.verdict in (EXCUSED, MARKED):
        return mark.verdict.capitalize()
    return HEADLINES[mark.result.verdict][0]


def total(mark: Mark) -> str:
    """`5 of 12 points`; empty if the exercise has no points."""
    if mark.points is None:
        return ""
    if mark.result and mark.points == tidy(mark.result.points):
        return total_of(mark.result)
    return f"{score(mark.points, mark.max_points)} points"


def decisions(mark: Mark) -> Iterator[str]:
    """One sentence for each decision that a person made: `By hand: +1 point. Well named.`"""
    titles = {check.id: check.title for check in (mark.result.checks if mark.result else ())}
    yield from (_decision(each, titles) for each in mark.by_hand if each != HandMark(excused=True))


def decisions_on_all(sheet: Sheet) -> Iterator[str]:
    """What a person decided about the whole submission, and what lateness cost."""
    yield from (_decision(each, {}) for each in sheet.by_hand)
    if sheet.late:
        yield late_words(sheet)


def says(sheet: Sheet) -> Iterator[str]:
    """What a learner is told about the submission as a whole, a sentence or two each."""
    if sheet.state == NOT_HANDED_IN:
        yield _NOTHING_IN_IT if sheet.source and sheet.remarks else _NOTHING_AT_ALL
    if sheet.state == INCOMPLETE:
        yield _OWED
    yield from decisions_on_all(sheet)
    yield from (f"Note: {remark}" for remark in sheet.remarks)


def comments(sheet: Sheet) -> Iterator[str]:
    """What people decided; a decision about an exercise begins with its id."""
    yield from decisions_on_all(sheet)
    yield from (f"{mark.exercise.id}: {said}" for mark in sheet.marks for said in decisions(mark))


def _decision(mark: HandMark, titles: Mapping[str, str]) -> str:
    parts = ["excused"] if mark.excused else []
    if mark.points is not None:
        parts.append(_points(mark.points))
    if mark.bonus:
        parts.append(f"{'+' if mark.bonus > 0 else '-'}{_points(abs(mark.bonus))}")
    about = f" for `{titles.get(mark.check, mark.check)}`" if mark.check else ""
    said = f"{mark.label}{about}: {', '.join(parts)}" if parts else f"Comment{about}"
    return f"{said}. {mark.comment}".strip() if parts else f"{said}: {mark.comment}"


def late_words(sheet: Sheet) -> str:
    """`Handed in 2 days late: 10 points become 8.`"""
    if sheet.lateness and not sheet.lateness.seconds:
        return "The submission time is not known, so lateness cost no points."
    if sheet.raw_points == sheet.judged_points:
        return f"Handed in {sheet.late}; this costs no points."
    before, after = number(sheet.raw_points), number(sheet.judged_points)
    return f"Handed in {sheet.late}: {before} points become {after}."


def _points(value: float) -> str:
    return f"{number(value)} {'point' if value == 1 else 'points'}"


def score(points: float | None, most: float | None) -> str:
    """`5 of 12`, or `-`."""
    return "-" if points is None or most is None else f"{number(points)} of {number(most)}"


def summary(sheet: Sheet) -> str:
    """`5 of 24 points`, or that they are not known yet."""
    if sheet.state == EXCUSED:
        return EXCUSED
    if sheet.points is None:
        judged = score(sheet.judged_points, sheet.judged_max)
        return f"not complete: {judged} points so far; a verdict is still missing"
    return f"{score(sheet.points, sheet.max_points)} points"


def why(check: CheckResult) -> Feedback | None:
    """Why a check did not pass; None if it did."""
    if check.outcome is Outcome.PASSED:
        return None
    cause = check.skipped_because or "the cause is not known"
    if check.outcome is Outcome.SKIPPED:
        return Feedback(f"Not judged: {cause}")
    if check.outcome is Outcome.NOT_APPLICABLE:
        return Feedback(f"Does not count here: {cause}")
    return check.feedback or Feedback("It did not pass.")


def labeled(feedback: Feedback) -> Iterator[tuple[str, str]]:
    """The parts below the cause, each with its label: expected, seen, in (places), try."""
    yield from comparison(feedback)
    yield from (("in", str(place)) for place in feedback.where)
    if feedback.advice:
        yield "try", feedback.advice


def text_of(feedback: Feedback) -> str:
    """The whole feedback as plain text, a line for each part."""
    parts = (f"{label.ljust(LABEL_WIDTH)}{text}" for label, text in labeled(feedback))
    return "\n".join((feedback.summary, *parts, *(f"| {line}" for line in feedback.details)))

"""The feedback file: what one learner is told, in Markdown that reads well as plain text too."""

from __future__ import annotations

from collections.abc import Iterator

from course.grading.result import CheckResult, Feedback
from course.report.gradebook.markup import code, fenced, plain, prose
from course.report.gradebook.sheets import INCOMPLETE, NOT_HANDED_IN, Mark, Sheet
from course.report.gradebook.words import NOTHING, headline, labelled, mark_of, points_of, summary, total, why

_INDENT = "  "
NOTHING_AT_ALL = "Nothing of yours was found. If you did hand something in, tell your instructor."
OWED = (
    "Something could not be checked, through no fault of yours: see below. "
    "Your points are final when that has been done."
)


def letter(sheet: Sheet, course: str) -> str:
    """The whole file. course: its title, clean."""
    blocks = [f"# Feedback for {plain(sheet.person.name or sheet.person.id)}", *_opening(sheet, course)]
    for mark in sheet.marks:
        blocks += section(mark, "##")
    return "\n\n".join(blocks) + "\n"


def section(mark: Mark, heading: str) -> Iterator[str]:
    """What became of one exercise, as blocks. heading: `##` or deeper."""
    yield f"{heading} {plain(mark.exercise.id)}: {plain(mark.exercise.title)}"
    points = total(mark)
    bonus = " It is a bonus." if mark.exercise.bonus else ""
    yield f"**{headline(mark)}**{f': {points}' if points else ''}.{bonus}"
    if mark.result is None:
        yield NOTHING
        return
    if mark.result.fault:
        yield from _feedback(mark.result.fault, "")
    for check in mark.result.checks:
        yield from _check(check)
    yield from (f"Note: {prose(note)}" for note in mark.result.notes)


def _opening(sheet: Sheet, course: str) -> Iterator[str]:
    yield f"{plain(course)}: {plain(summary(sheet))}."
    if sheet.source:
        yield f"Handed in: {code(sheet.source)}"
    if sheet.state == NOT_HANDED_IN:
        yield NOTHING_AT_ALL
    if sheet.state == INCOMPLETE:
        yield OWED
    yield from (f"Note: {prose(remark)}" for remark in sheet.remarks)


def _check(check: CheckResult) -> Iterator[str]:
    points = points_of(check)
    yield f"- **{mark_of(check)}** {prose(check.title)}{f' ({points})' if points else ''}"
    feedback = why(check)
    if feedback:
        yield from _feedback(feedback, _INDENT)


def _feedback(feedback: Feedback, indent: str) -> Iterator[str]:
    yield f"{indent}{prose(feedback.summary)}"
    parts = [f"{indent}- {label}: {_part(label, text)}" for label, text in labelled(feedback)]
    if parts:
        yield "\n".join(parts)
    if feedback.details:
        yield fenced(feedback.details, indent)


def _part(label: str, text: str) -> str:
    return code(text) if label == "in" else prose(text)

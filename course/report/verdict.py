"""A verdict, as a learner reads it after `check`.

It works without color and with 80 columns. Every text of a check may contain output of a
submission, so all texts are made safe here.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from rich.console import Console
from rich.text import Text

from course.model.result import CheckResult, Doubt, Feedback, Outcome, Result, Verdict
from course.report import sanitize
from course.report.console import number, put, put_prose, with_code

if TYPE_CHECKING:
    from course.content import Exercise

MARKS = {
    Outcome.PASSED: ("ok", "bold green"),
    Outcome.FAILED: ("no", "bold red"),
    Outcome.SKIPPED: ("--", "dim"),
    Outcome.NOT_APPLICABLE: ("..", "dim"),
    Outcome.ERROR: ("!!", "bold magenta"),
}
HEADLINES = {
    Verdict.PASSED: ("Passed", "bold green"),
    Verdict.NOT_PASSED: ("Not passed yet", "bold red"),
    Verdict.NOT_APPLICABLE: ("Does not apply here", "bold yellow"),
    Verdict.NOT_AVAILABLE: ("Could not be checked on this machine", "bold yellow"),
    Verdict.OUR_ERROR: ("The course itself has an error", "bold magenta"),
}
INDENT = " " * 6
LABEL_WIDTH = 10
PLACES = 5
_BUSY = ("Could not be judged now", "bold yellow")


def render_result(
    console: Console, result: Result, exercise: Exercise, previous: Result | None = None
) -> None:
    """The checks one by one, what to do about each, and the total; `previous` is for comparison."""
    put(console, Text.assemble((exercise.id, "bold"), "  ", exercise.title))
    put(console)
    render_checks(console, result.checks, previous)
    if result.checks:
        put(console)
    put(console, headline(result, previous))
    render_remarks(console, result)


def render_so_far(console: Console, result: Result) -> None:
    """What is certain while the cause of a failure is still unknown: the total, and what failed."""
    put(console, headline(result, None))
    for check in result.checks:
        if check.outcome is Outcome.FAILED and check.feedback:
            text = sanitize.paragraph(f"{check.title}: {check.feedback.summary}")
            put_prose(console, with_code(console, text), first="  failed: ")


def render_remarks(console: Console, result: Result) -> None:
    """What to say in addition to the checks: a fault of ours, and facts about this machine."""
    if result.fault:
        put_feedback(console, result.fault)
    for note in result.notes:
        put_prose(console, with_code(console, sanitize.paragraph(note), "dim"), first="  Note: ")


def render_checks(console: Console, checks: Iterable[CheckResult], previous: Result | None = None) -> None:
    """The checks alone, in the order given."""
    before = {check.id: check.outcome for check in previous.checks} if previous else {}
    for check in checks:
        _put_check(console, check, before.get(check.id))


def put_feedback(console: Console, feedback: Feedback) -> None:
    """Why something did not pass: the cause, expected and seen, where, what to do, evidence."""
    put_prose(console, with_code(console, sanitize.paragraph(feedback.summary)), first=INDENT)
    for label, text in comparison(feedback):
        _put_labelled(console, label, with_code(console, text))
    for place in feedback.where[:PLACES]:
        line = Text.assemble(
            INDENT, ("in".ljust(LABEL_WIDTH), "dim"), (sanitize.one_line(str(place)), "bold")
        )
        put(console, line)
    if feedback.advice:
        _put_labelled(console, "try", with_code(console, sanitize.paragraph(feedback.advice)))
    for line_of_evidence in sanitize.details(feedback.details):
        put_prose(console, Text(line_of_evidence, "dim"), first=f"{INDENT}| ", rest=f"{INDENT}|   ")


def _put_check(console: Console, check: CheckResult, before: Outcome | None) -> None:
    mark, style = MARKS[check.outcome]
    points = earned_of(check)
    room = max(console.width - len(INDENT) - len(points) - 2, 20)
    title = with_code(console, sanitize.paragraph(check.title)).wrap(console, room)
    for row, line in enumerate(title):
        line.rstrip()
        head = Text.assemble("  ", (mark, style), "  ") if row == 0 else Text(INDENT)
        tail = f"{' ' * (room - line.cell_len)}  {points}" if row == 0 and points else ""
        put(console, Text.assemble(head, line, (tail, "dim")))
    if before is Outcome.PASSED and check.outcome is Outcome.FAILED:
        put_prose(console, Text("This check passed last time.", "yellow"), first=INDENT)
    if check.feedback and check.outcome in (Outcome.FAILED, Outcome.ERROR):
        put_feedback(console, check.feedback)
    if check.feedback and check.outcome is Outcome.PASSED:
        put_prose(
            console, with_code(console, sanitize.paragraph(check.feedback.summary), "dim"), first=INDENT
        )
    if check.outcome is Outcome.SKIPPED:
        cause = sanitize.paragraph(check.skipped_because or "the cause is not known")
        put_prose(console, with_code(console, f"Not judged: {cause}", "dim"), first=INDENT)
    if check.outcome is Outcome.NOT_APPLICABLE:
        cause = sanitize.paragraph(check.skipped_because or "the cause is not known")
        put_prose(console, with_code(console, f"Does not count here: {cause}", "dim"), first=INDENT)


def earned_of(check: CheckResult) -> str:
    """`2`, `0 of 2`, `bonus 0.5`; empty if the check does not apply."""
    word = "bonus " if check.bonus else ""
    if check.outcome is Outcome.PASSED and check.share == 1:
        return f"{word}{number(check.points)}"
    if check.outcome is Outcome.NOT_APPLICABLE:
        return ""
    return f"{word}{number(check.earned)} of {number(check.points)}"


def headline(result: Result, previous: Result | None = None) -> Text:
    """The verdict with its points, in one line."""
    word, style = _BUSY if result.doubt is Doubt.BUSY else HEADLINES[result.verdict]
    counted = result.verdict in (Verdict.PASSED, Verdict.NOT_PASSED)
    points = f": {total_of(result)}{_change(result, previous)}."
    rest = points if counted else ". This attempt does not count."
    return Text.assemble("  ", (word, style), rest, (_seconds(result), "dim"))


def total_of(result: Result) -> str:
    """`2 of 2 points`, `2 of 2 points, bonus 0.5`."""
    unit = "point" if result.max_points == 1 else "points"
    bonus = sum(check.earned for check in result.checks if check.bonus)
    extra = f", bonus {number(bonus)}" if bonus else ""
    return f"{number(result.points - bonus)} of {number(result.max_points)} {unit}{extra}"


def _change(result: Result, previous: Result | None) -> str:
    if previous is None or previous.points == result.points:
        return ""
    return f" (last time {number(previous.points)})"


def _seconds(result: Result) -> str:
    timing = result.timing
    if timing.total <= 0:
        return ""
    return f"  [built in {timing.build:.1f} s, watched for {timing.evidence:.1f} s]"


def comparison(feedback: Feedback) -> Iterator[tuple[str, str]]:
    if feedback.expected is not None:
        yield "expected", sanitize.paragraph(feedback.expected)
    if feedback.seen is not None:
        yield "seen", sanitize.paragraph(feedback.seen)


def _put_labelled(console: Console, label: str, text: Text) -> None:
    lead = f"{INDENT}{label.ljust(LABEL_WIDTH)}"
    put_prose(console, text, first=lead)

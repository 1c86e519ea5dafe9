"""Fills the screen's middle: lesson, task, result, hint, list."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import singledispatch

from rich.console import Console
from rich.text import Text

from course.grading.result import CheckResult, Outcome
from course.grading.result import Verdict as Ending
from course.report import safe
from course.report.console import number, put, put_prose
from course.report.lesson import (
    put_requires,
    render_after,
    render_exercise,
    render_hint,
    render_lesson,
    render_new_files,
)
from course.report.overview import render_list
from course.report.problem import render_our_fault, render_problem
from course.report.questions import render_questions
from course.report.terminal import headline, render_checks, render_remarks
from course.watch.changes import Change
from course.watch.model import AllPassed, Body, HintText, LessonText, Listing, Problem, TaskText, Verdict

# What is to be done comes before what is done.
_ORDER = (Outcome.FAILED, Outcome.ERROR, Outcome.SKIPPED, Outcome.PASSED, Outcome.NOT_APPLICABLE)

Typed = Callable[[str], str]


@singledispatch
def render(body: Body, console: Console, typed: Typed) -> None:
    """Print it on the console. typed: one of our commands as it can be typed here."""
    raise TypeError(f"nothing tells how to show {body!r}")


@render.register
def _lesson(body: LessonText, console: Console, typed: Typed) -> None:
    for lesson in body.lessons:
        render_lesson(console, lesson.chapter, lesson.text)
    put(console, "Press t for the task.", "bold")


@render.register
def _task(body: TaskText, console: Console, typed: Typed) -> None:
    render_exercise(console, body.exercise, body.home, body.state)
    render_new_files(console, body.home, body.new)
    put_requires(console, body.needed)
    if body.questions:
        render_questions(console, body.questions)


@render.register
def _verdict(body: Verdict, console: Console, typed: Typed) -> None:
    result = body.result
    put(console, headline(result, body.previous))
    if result.verdict is Ending.PASSED:
        put(console, "  Press n for the next exercise.", "bold")
    if body.change is not None:
        _put_change(console, body.change)
    put(console)
    render_checks(console, _most_urgent_first(result.checks), body.previous)
    render_remarks(console, result)
    if result.verdict is Ending.OUR_ERROR:
        render_our_fault(console, body.log)
    if result.verdict is Ending.PASSED and body.exercise.after:
        render_after(console, body.exercise.after)


@render.register
def _problem(body: Problem, console: Console, typed: Typed) -> None:
    render_problem(console, body.what, body.next_step)


@render.register
def _hint(body: HintText, console: Console, typed: Typed) -> None:
    if body.total == 0:
        put(console, f"There are no hints for {body.exercise.id}.")
        return
    render_hint(console, body.exercise.id, body.number, body.total, body.text)
    if body.number < body.total:
        put(console, "Press h for the next hint.")
    else:
        put(console, f"That was the last hint. `{typed(f'hint {body.exercise.id} --all')}` shows them all.")


@render.register
def _list(body: Listing, console: Console, typed: Typed) -> None:
    render_list(console, body.rows, body.chapters)


@render.register
def _all_passed(body: AllPassed, console: Console, typed: Typed) -> None:
    put(console, "You have passed every exercise of this course. Well done!", "bold green")
    put(console)
    put(console, f"Press q to leave. `{typed('next ID')}` goes back to one of them.")


def _most_urgent_first(checks: Iterable[CheckResult]) -> list[CheckResult]:
    return sorted(checks, key=lambda check: _ORDER.index(check.outcome))


def _put_change(console: Console, change: Change) -> None:
    if change.is_nothing:
        put(console, "  Since the last check: nothing has changed.", "dim")
        return
    put(console, Text.assemble("  Since the last check: ", (gain(change), "bold")))
    for mark, style, titles in (("+", "green", change.fixed), ("-", "yellow", change.broken)):
        said = "passes now" if mark == "+" else "does not pass any more"
        for title in titles:
            text = Text(f"{safe.paragraph(title)} {said}", style)
            put_prose(console, text, first=f"    {mark} ", rest=" " * 6)


def gain(change: Change) -> str:
    """The points that were won or lost: `3 points more`."""
    points = abs(change.points)
    unit = "point" if points == 1 else "points"
    if not points:
        return "as many points"
    return f"{number(points)} {unit} {'more' if change.points > 0 else 'fewer'}"

"""`hint`: one more hint each time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.session import CourseSession, CurrentExercise, open_session
from course.cli.usage import examples, typed
from course.report.console import open_console, put, put_steps
from course.report.exercise_text import render_hint

if TYPE_CHECKING:
    from rich.console import Console

    from course.content import Exercise

EXAMPLES = examples(
    ("hint", "the next hint for your current exercise"),
    ("hint 18-publisher", "for another one"),
    ("hint --again", "the last one again"),
    ("hint --all", "all of them"),
)


def hint(
    ctx: typer.Context,
    exercise: CurrentExercise = None,
    again: Annotated[bool, typer.Option("--again", help="Show the last one again.")] = False,
    all_: Annotated[bool, typer.Option("--all", help="Show all of them.")] = False,
) -> None:
    """Show the next hint for an exercise.

    Each call shows one more hint. The course remembers which ones you have seen.
    """
    with open_session(ctx) as session:
        _show(open_console(), session, session.exercise(exercise), again=again, every=all_)


def _show(console: Console, session: CourseSession, exercise: Exercise, *, again: bool, every: bool) -> None:
    total = len(exercise.hints)
    if total == 0:
        put(console, f"There are no hints for {exercise.id}.")
    for index in _indices(session, exercise, again=again, every=every):
        render_hint(console, exercise.id, index + 1, total, exercise.hints[index])
    last = session.progress.hints_shown(exercise.id) >= total
    if last and total:
        put(console, "That was the last hint.")
        put(console)
    put_steps(console, _steps(exercise, last=last))


def _indices(session: CourseSession, exercise: Exercise, *, again: bool, every: bool) -> range:
    """Which hints to show, from 0; showing a new one is remembered."""
    total = len(exercise.hints)
    shown = min(session.progress.hints_shown(exercise.id), total)
    if every or total == 0:
        while session.progress.hints_shown(exercise.id) < total:
            session.progress.next_hint(exercise.id, total)
        return range(total)
    index = shown - 1 if again and shown else session.progress.next_hint(exercise.id, total)
    return range(index, index + 1)


def _steps(exercise: Exercise, *, last: bool) -> list[tuple[str, str]]:
    is_quiz = exercise.questions and not exercise.packages
    check = (typed("check"), "to answer the questions" if is_quiz else "when you have changed something")
    if last:
        return [
            check,
            (typed(f"solution {exercise.id} --anyway"), "for a solution"),
        ]
    return [check, (typed("hint"), "for the next hint")]

"""`hint`: one hint more each time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.arguments import CurrentExercise
from course.cli.words import examples, typed

if TYPE_CHECKING:
    from rich.console import Console

    from course.cli.desk import Desk
    from course.content import Exercise

EXAMPLES = examples(
    ("hint", "the next hint for the exercise you are at"),
    ("hint 18-publisher", "for another one"),
    ("hint --again", "the last one once more"),
    ("hint --all", "all of them"),
)


def hint(
    ctx: typer.Context,
    exercise: CurrentExercise = None,
    again: Annotated[bool, typer.Option("--again", help="Show the last one once more.")] = False,
    all_: Annotated[bool, typer.Option("--all", help="Show all of them.")] = False,
) -> None:
    """Show the next hint for an exercise.

    Each call goes one hint further, and what you have seen is remembered.
    """
    from course.cli.desk import open_desk
    from course.report.console import open_console

    with open_desk(ctx) as desk:
        _show(open_console(), desk, desk.exercise(exercise), again=again, every=all_)


def _show(console: Console, desk: Desk, exercise: Exercise, *, again: bool, every: bool) -> None:
    from course.report.console import put, put_steps
    from course.report.lesson import render_hint

    total = len(exercise.hints)
    if total == 0:
        put(console, f"There are no hints for {exercise.id}.")
    for index in _indices(desk, exercise, again=again, every=every):
        render_hint(console, exercise.id, index + 1, total, exercise.hints[index])
    last = desk.progress.hints_shown(exercise.id) >= total
    if last and total:
        put(console, "That was the last hint.")
        put(console)
    put_steps(console, _steps(exercise, last=last))


def _indices(desk: Desk, exercise: Exercise, *, again: bool, every: bool) -> range:
    """Which hints to show, from 0; showing a new one is remembered."""
    total = len(exercise.hints)
    shown = min(desk.progress.hints_shown(exercise.id), total)
    if every or total == 0:
        while desk.progress.hints_shown(exercise.id) < total:
            desk.progress.next_hint(exercise.id, total)
        return range(total)
    index = shown - 1 if again and shown else desk.progress.next_hint(exercise.id, total)
    return range(index, index + 1)


def _steps(exercise: Exercise, *, last: bool) -> list[tuple[str, str]]:
    check = (typed("check"), "when you have changed something")
    if exercise.questions and not exercise.packages:
        check = (typed("check --again"), "to answer what is not right yet")
    if last:
        return [
            check,
            (typed(f"solution {exercise.id} --anyway"), "for a solution"),
        ]
    return [check, (typed("hint"), "for the next hint")]

"""`reset`: an exercise's files as they were at its beginning; yours go to a backup."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.arguments import ExerciseId
from course.cli.words import examples, typed

if TYPE_CHECKING:
    from course.content import Exercise

EXAMPLES = examples(
    ("reset 18-publisher", "begin anew; yours goes to a backup"),
    ("reset 18-publisher --yes", "without being asked"),
)


def reset(
    ctx: typer.Context,
    exercise: ExerciseId,
    yes: Annotated[bool, typer.Option("--yes", "-y", help="Do not ask.")] = False,
) -> None:
    """Lay an exercise's files as they were at its beginning.

    What you wrote is not lost: it goes to a dated backup in your course home,
    and you are told where.
    """
    from course.cli.desk import open_desk
    from course.home import reset as reset_files
    from course.report.console import open_console, put_steps
    from course.report.lesson import render_reset

    with open_desk(ctx) as desk:
        chosen = desk.exercise(exercise)
        if not yes and sys.stdin.isatty() and not _agrees(chosen):
            typer.echo("Nothing was changed.")
            raise typer.Exit()
        report = reset_files(desk.home, chosen)
    console = open_console()
    render_reset(console, report)
    put_steps(console, [(typed(f"show {chosen.id}"), "to read the exercise again")])


def _agrees(exercise: Exercise) -> bool:
    typer.echo("These files go to a backup, and the exercise's first ones take their place:")
    for file in exercise.files:
        typer.echo(f"  {file}")
    try:
        return typer.confirm("Go on?")
    except typer.Abort:
        raise KeyboardInterrupt from None

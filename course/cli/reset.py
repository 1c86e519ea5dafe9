"""`reset`: puts an exercise's files back as they were at its start; yours go to a backup."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.session import ExerciseId, open_session
from course.cli.usage import examples, typed
from course.home import reset as reset_files
from course.report.console import open_console, put_steps
from course.report.exercise_text import render_reset

if TYPE_CHECKING:
    from course.content import Exercise

EXAMPLES = examples(
    ("reset 18-publisher", "start again; your files go to a backup"),
    ("reset 18-publisher --yes", "without a question"),
)


def reset(
    ctx: typer.Context,
    exercise: ExerciseId,
    yes: Annotated[bool, typer.Option("--yes", "-y", help="Do not ask for confirmation.")] = False,
) -> None:
    """Put an exercise's files back as they were at the start.

    Your work is not lost: it is moved to a dated backup in your course home,
    and the command says where.
    """
    with open_session(ctx) as session:
        chosen = session.exercise(exercise)
        if not yes and sys.stdin.isatty() and not _agrees(chosen):
            typer.echo("Nothing was changed.")
            raise typer.Exit()
        report = reset_files(session.home, chosen)
    console = open_console()
    render_reset(console, report)
    put_steps(console, [(typed(f"show {chosen.id}"), "to read the exercise again")])


def _agrees(exercise: Exercise) -> bool:
    typer.echo("These files go to a backup, and the exercise's original files replace them:")
    for file in exercise.files:
        typer.echo(f"  {file}")
    try:
        return typer.confirm("Continue?")
    except typer.Abort:
        raise KeyboardInterrupt from None

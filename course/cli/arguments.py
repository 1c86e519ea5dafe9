"""Arguments and options that several commands share, and how the shell completes them."""

from __future__ import annotations

from typing import Annotated

import typer


def complete_exercise(ctx: typer.Context, incomplete: str) -> list[tuple[str, str]]:
    """Exercise ids with their titles. In the middle of a command line, a fault only means no help."""
    from course.cli.desk import course_here
    from course.cli.options import options_of
    from course.errors import CourseError

    try:
        exercises = course_here(options_of(ctx)).exercises()
    except CourseError:
        return []
    return [(one.id, one.title) for one in exercises if one.id.startswith(incomplete)]


ExerciseId = Annotated[
    str,
    typer.Argument(
        metavar="ID",
        help="The exercise, such as 18-publisher; a part that fits only one will do.",
        autocompletion=complete_exercise,
    ),
]
CurrentExercise = Annotated[
    str | None,
    typer.Argument(
        metavar="ID",
        help="The exercise, such as 18-publisher; a part that fits only one will do. "
        "Without it, the one you are at.",
        autocompletion=complete_exercise,
        show_default=False,
    ),
]
Pager = Annotated[bool, typer.Option("--pager", help="Show the text one screen at a time.")]

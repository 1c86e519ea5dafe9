"""`show`: the text of an exercise."""

from __future__ import annotations

from contextlib import nullcontext
from typing import Annotated

import typer

from course.cli.arguments import CurrentExercise, Pager
from course.cli.words import examples

EXAMPLES = examples(
    ("show", "the exercise you are at"),
    ("show 18-publisher", "another one"),
    ("show 18-publisher --lesson", "with its chapter's lesson"),
)


def show(
    ctx: typer.Context,
    exercise: CurrentExercise = None,
    lesson: Annotated[bool, typer.Option("--lesson", help="The chapter's lesson before it.")] = False,
    pager: Pager = False,
) -> None:
    """Show the text of an exercise. Changes nothing."""
    from course.cli.desk import open_desk
    from course.cli.reading import put_questions
    from course.report.console import open_console, paged
    from course.report.lesson import render_exercise, render_lesson

    console = open_console()
    with open_desk(ctx) as desk:
        shown = desk.exercise(exercise)
        state = desk.progress.state(shown.id)
        with paged(console) if pager else nullcontext():
            for read in desk.course.lessons(shown) if lesson else ():
                render_lesson(console, read.chapter, read.text)
            render_exercise(console, shown, desk.home.path, state)
            put_questions(console, desk, shown)

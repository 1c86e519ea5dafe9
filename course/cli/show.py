"""`show`: the text of an exercise."""

from __future__ import annotations

from contextlib import nullcontext
from typing import Annotated

import typer

from course.cli.session import CurrentExercise, Pager, open_session
from course.cli.usage import examples
from course.report.console import open_console, paged
from course.report.exercise_text import render_exercise, render_lesson

EXAMPLES = examples(
    ("show", "your current exercise"),
    ("show 18-publisher", "another one"),
    ("show 18-publisher --lesson", "with its chapter's whole lesson"),
)


def show(
    ctx: typer.Context,
    exercise: CurrentExercise = None,
    lesson: Annotated[bool, typer.Option("--lesson", help="Show the chapter's whole lesson first.")] = False,
    pager: Pager = False,
) -> None:
    """Show the text of an exercise. Changes nothing."""
    console = open_console()
    with open_session(ctx) as session:
        shown = session.exercise(exercise)
        state = session.progress.state(shown.id)
        with paged(console) if pager else nullcontext():
            for read in session.course.lessons(shown, whole=True) if lesson else ():
                render_lesson(console, read.chapter, read.text)
            render_exercise(console, shown, session.home.path, state)
            if shown.questions:
                from course.cli.quiz import put_questions  # takes three times as long as everything else

                put_questions(console, session, shown)

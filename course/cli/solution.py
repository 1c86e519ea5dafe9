"""`solution`: the reference solution, shown as the difference to the learner's files."""

from __future__ import annotations

from contextlib import nullcontext
from typing import Annotated

import typer

from course.cli.quiz import right_answers_of
from course.cli.session import CurrentExercise, Pager, open_session
from course.cli.usage import examples, typed
from course.errors import UsageError
from course.home import solution_diff
from course.report.console import open_console, paged
from course.report.exercise_text import render_diff

EXAMPLES = examples(
    ("solution 18-publisher", "after you have passed it"),
    ("solution 18-publisher --anyway", "before that"),
)


def solution(
    ctx: typer.Context,
    exercise: CurrentExercise = None,
    anyway: Annotated[bool, typer.Option("--anyway", help="Show it even if you have not passed.")] = False,
    pager: Pager = False,
) -> None:
    """Show how a solution differs from your files.

    Lines with - are yours, lines with + are the solution's. Nothing is changed.
    There are other right ways, too: `check` judges what your program does.
    """
    with open_session(ctx) as session:
        chosen = session.exercise(exercise)
        if not anyway and not session.is_passed(chosen.id):
            what = f"You have not passed {chosen.id} yet, and seeing the solution would spoil it."
            steps = (
                f"`{typed('hint')}` gives a hint. `{typed(f'solution {chosen.id} --anyway')}` shows it now."
            )
            raise UsageError(what, steps)
        diffs = solution_diff(session.home, chosen, right_answers_of(session, chosen))
    console = open_console()
    with paged(console) if pager else nullcontext():
        render_diff(console, diffs)

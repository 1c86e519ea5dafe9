"""`solution`: the reference solution, shown as the difference to the learner's files."""

from __future__ import annotations

from typing import Annotated

import typer

from course.cli.arguments import CurrentExercise, Pager
from course.cli.words import examples, typed

EXAMPLES = examples(
    ("solution 18-publisher", "after you have passed it"),
    ("solution 18-publisher --anyway", "before that"),
)


def solution(
    ctx: typer.Context,
    exercise: CurrentExercise = None,
    anyway: Annotated[bool, typer.Option("--anyway", help="Also when you have not passed it.")] = False,
    pager: Pager = False,
) -> None:
    """Show a solution as the difference to your files.

    Lines with - are yours, lines with + are the solution's. Nothing is changed,
    and there are other right ways: `check` judges what your program does.
    """
    from contextlib import nullcontext

    from course.cli.desk import open_desk
    from course.cli.reading import right_answers_of
    from course.errors import UsageError
    from course.home import solution_diff
    from course.report.console import open_console, paged
    from course.report.diff import render_diff

    with open_desk(ctx) as desk:
        chosen = desk.exercise(exercise)
        if not anyway and not desk.is_passed(chosen.id):
            what = f"{chosen.id} is not passed yet: its solution would spoil it."
            steps = (
                f"`{typed('hint')}` gives a hint. `{typed(f'solution {chosen.id} --anyway')}` shows it now."
            )
            raise UsageError(what, steps)
        diffs = solution_diff(desk.home, chosen, right_answers_of(desk, chosen))
    console = open_console()
    with paged(console) if pager else nullcontext():
        render_diff(console, diffs)

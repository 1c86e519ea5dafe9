"""`regrade`: the marks of a class by the checks as they are now."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.options import Options, options_of
from course.cli.words import examples, typed
from course.errors import UsageError

if TYPE_CHECKING:
    from course.batch.regrade import Moved, Regraded
    from course.batch.results import Results
    from course.report.moves import Row

EXAMPLES = examples(
    ("regrade grades/", "after points or checks were changed"),
    ("regrade grades/ --rerun", "and run again where that is needed"),
)


def regrade(
    ctx: typer.Context,
    results: Annotated[Path, typer.Argument(metavar="DIR", help="The results' folder of `grade`.")],
    rerun: Annotated[
        bool, typer.Option("--rerun", help="Grade those anew whose recordings do not suffice.")
    ] = False,
    jobs: Annotated[
        int | None, typer.Option("--jobs", min=1, max=64, help="Processes at once; by default one a core.")
    ] = None,
) -> None:
    """Judge a graded class again.

    By the recordings that `grade` keeps: changed points, tolerances and checks
    take effect, and no submission is run. Shows whose marks moved, and why. All
    marks move together, or none do.
    """
    from course.batch.regrade import forget_lacking
    from course.batch.run import results_folder

    options, out = options_of(ctx), results.absolute()
    _is_there(out)
    with results_folder(out) as stored:
        found = _judge_again(options, out, stored, jobs)
        _show(found, out, rerun=rerun)
        if rerun:
            forget_lacking(stored, found.lacking)
    if rerun and found.lacking:
        _grade_anew(options, out)


def _is_there(out: Path) -> None:
    from course.batch.results import FILE

    if not (out / FILE).is_file():
        raise UsageError(f"No results of `grade` are in {out}.", "Name the folder that was given to --out.")


def _judge_again(options: Options, out: Path, stored: Results, jobs: int | None) -> Regraded:
    from course.batch.regrade import regrade as judge_again
    from course.cli.class_ import report_again
    from course.cli.desk import course_of
    from course.report.activity import activity
    from course.report.console import error_console

    course = course_of(options)
    with activity(error_console(), "judging again", quiet=True) as say:

        def told(done: int, total: int) -> None:
            say(f"judging again: {done} of {total}")

        found = judge_again(out, stored, course, told, jobs=jobs)
        report_again(course, stored, out)
    return found


def _show(found: Regraded, out: Path, *, rerun: bool) -> None:
    from course.report.console import open_console
    from course.report.moves import render_lacking, render_moves

    console = open_console()
    render_moves(console, [_row(one) for one in found.moved], found.judged)
    lacking = [(one.person, one.exercise, one.why) for one in found.lacking]
    command = "it is done now." if rerun else f"`{typed('regrade')} {out.name} --rerun`"
    render_lacking(console, lacking, command)


def _row(moved: Moved) -> Row:
    from course.report.moves import Row

    reasons = [f"{move.title}: {move.why}" for move in moved.moves]
    return Row(moved.name, moved.exercise, moved.before, moved.after, reasons)


def _grade_anew(options: Options, out: Path) -> None:
    from course.cli.class_ import grade_again
    from course.cli.desk import course_of

    grade_again(course_of(options), out, options.course)

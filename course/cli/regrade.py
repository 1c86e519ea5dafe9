"""`regrade`: judges a class again with the current checks."""

from __future__ import annotations

import shlex
from pathlib import Path
from typing import Annotated

import typer

from course.batch.class_page import decisions_in
from course.batch.regrade import Regraded, forget_lacking
from course.batch.regrade import regrade as judge_again
from course.batch.results import FILE, Results, people_of, settings_of
from course.batch.run import results_folder
from course.cli.grade import grade_again, report_again
from course.cli.options import Options, options_of
from course.cli.session import course_of
from course.cli.usage import examples, typed
from course.errors import UsageError
from course.report.activity import activity
from course.report.batch import render_lacking, render_moves
from course.report.console import error_console, open_console, put

EXAMPLES = examples(
    ("regrade grades/", "after points or checks were changed"),
    ("regrade grades/ --dry-run", "only show whose marks would change"),
    ("regrade grades/ --rerun", "and run again where that is needed"),
)


def regrade(
    ctx: typer.Context,
    results: Annotated[Path, typer.Argument(metavar="DIR", help="The results folder of `grade`.")],
    rerun: Annotated[
        bool, typer.Option("--rerun", help="Grade again where the recordings are not enough.")
    ] = False,
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Show whose marks would change, and change nothing.")
    ] = False,
    jobs: Annotated[
        int | None,
        typer.Option("--jobs", min=1, max=64, help="How many processes to use; by default, one per core."),
    ] = None,
) -> None:
    """Judge a graded class again.

    Uses the recordings that `grade` keeps, so changed points, tolerances, and
    checks take effect, but no submission runs. Shows whose marks changed, and
    why. Either all changes are saved, or none are.
    """
    if rerun and dry_run:
        raise UsageError("--rerun grades again, and --dry-run changes nothing.", "Give one of them.")
    options, out = options_of(ctx), results.absolute()
    _is_there(out)
    with results_folder(out) as stored:
        found = _judge_again(options, out, stored, jobs, dry_run=dry_run)
        _show(found, results, rerun=rerun)
        if dry_run:
            put(open_console(), "Nothing was changed.")
        if rerun:
            forget_lacking(stored, found.lacking)
    if rerun and found.lacking:
        _grade_anew(options, out)


def _is_there(out: Path) -> None:
    if not (out / FILE).is_file():
        raise UsageError(f"{out} has no results of `grade`.", "Name the folder given to --out.")


def _judge_again(
    options: Options, out: Path, stored: Results, jobs: int | None, *, dry_run: bool
) -> Regraded:
    course = course_of(options)
    asked = settings_of(stored).exercises
    exercises = [exercise for exercise in course.exercises() if exercise.id in asked]
    decisions_in(out, people_of(stored), exercises)  # report typos before anything changes
    with activity(error_console(), "judging again", quiet=True) as say:

        def told(done: int, total: int) -> None:
            say(f"judging again: {done} of {total}")

        found = judge_again(out, stored, course, told, jobs=jobs, dry_run=dry_run)
        if not dry_run:
            report_again(course, stored, out)
    return found


def _show(found: Regraded, out: Path, *, rerun: bool) -> None:
    console = open_console()
    render_moves(console, found.moved, found.judged)
    lacking = [(one.person, one.exercise, one.why) for one in found.lacking]
    command = "it is done now." if rerun else f"`{typed('regrade')} {shlex.quote(str(out))} --rerun`"
    render_lacking(console, lacking, command)


def _grade_anew(options: Options, out: Path) -> None:
    grade_again(course_of(options), out, options.course)

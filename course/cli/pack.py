"""`pack`: a zip to hand in, checked before it is made."""

from __future__ import annotations

import platform
import tempfile
from datetime import datetime, timezone
from pathlib import Path
from typing import Annotated

import typer

import course
from course.batch.batch_plan import exercises_named, lacking
from course.batch.intake import SubmissionKind, lay_out, look, one_source
from course.batch.intake.packed import manifest_of, needed_files
from course.cli.check import exit_code
from course.cli.session import CourseSession, complete_exercise, open_session
from course.cli.signals import ended_cleanly
from course.cli.usage import examples, typed
from course.content import Exercise
from course.errors import UsageError
from course.files import write_pieces
from course.grading.check import Request, check_exercise
from course.grading.load import runs_programs
from course.home.opening import Refused
from course.home.storage import storing
from course.model.result import Result, Verdict
from course.report.activity import activity
from course.report.batch import line_of
from course.report.console import error_console, open_console, put
from course.report.gradebook.gradescope import zipped
from course.rosenv import Ros, find_ros

EXAMPLES = examples(
    ("pack", "your current exercise"),
    ("pack 17 18", "all exercises in two chapters"),
    ("pack 18-publisher --out ada.zip", "under another name"),
)


def pack(
    ctx: typer.Context,
    exercises: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[EXERCISE]...",
            help="Exercises, or chapters by number. By default, the current exercise.",
            autocompletion=complete_exercise,
            show_default=False,
        ),
    ] = None,
    out: Annotated[Path, typer.Option("--out", metavar="FILE", help="The zip.")] = Path("hand-in.zip"),
) -> None:
    """Make a zip to hand in.

    It contains only the files that these exercises need. They are checked as
    they are in the zip, without the rest of your course home, so you see what
    your instructor will see. The zip also records the results, the versions of
    your software, and a digest of each file. The exit codes are those of `check`.
    """
    with open_session(ctx) as session:
        chosen = _chosen(session, exercises or [])
        with storing(f"{out} cannot be written"):
            results, lacks = _packed(session, chosen, out)
    console = open_console()
    for result in results:
        put(console, line_of(out.name, result))
    put(console, f"{out} is ready to hand in: {out.stat().st_size / 1000:.0f} kB.")
    for package in lacks:
        told = f"{out} lacks the package {package}, because it is not in your course home."
        put(console, f"{told} `grade` uses the course's own, so your instructor's result can differ.")
    for result in results:
        if result.verdict is not Verdict.PASSED:
            put(console, f"`{typed(f'check {result.exercise}')}` shows what is not right yet.")
    raise typer.Exit(max(map(exit_code, results)))


def _chosen(session: CourseSession, names: list[str]) -> tuple[Exercise, ...]:
    found = exercises_named(session.course, names) or (session.exercise(None),)
    chosen = tuple(one for one in found if not one.local_only)
    if not chosen:
        raise UsageError(f"{found[0].id} is about your own computer, so nothing is handed in for it.")
    return chosen


def _packed(
    session: CourseSession, chosen: tuple[Exercise, ...], out: Path
) -> tuple[list[Result], list[str]]:
    """The results of the check, and the packages that the zip lacks."""
    home = session.home
    try:
        files = needed_files(home.path, chosen)
    except Refused as error:
        raise UsageError(error.finding.what, error.finding.advice) from None
    with tempfile.TemporaryDirectory(prefix="ros2course-pack-") as name:
        folder = Path(name)
        (folder / "hand-in.zip").write_bytes(zipped(files))
        (source,) = one_source(folder / "hand-in.zip").each
        found = look(source, folder / "opened", session.course.exercises())
        if found.kind is SubmissionKind.NOTHING or not set(found.exercises).intersection(
            one.id for one in chosen
        ):
            raise UsageError(f"There are no files of {chosen[0].id} in {home.path} yet.")
        lay_out(found, folder / "home")
        ros = find_ros() if any(map(runs_programs, chosen)) else None
        results = [_checked(one, folder / "home", ros, home.seed()) for one in chosen]
    versions = {"ros2course": course.__version__, "python": platform.python_version()}
    versions |= {"ros": f"{ros.distro} ({ros.origin})"} if ros else {}
    at = datetime.now(timezone.utc).isoformat(timespec="seconds")
    write_pieces(out.absolute(), [zipped((*files, manifest_of(files, results, versions, at)))])
    return results, lacking(found, chosen)


def _checked(exercise: Exercise, home: Path, ros: Ros | None, seed: int) -> Result:
    with ended_cleanly(), activity(error_console(), f"checking {exercise.id}", quiet=True) as say:
        return check_exercise(Request(exercise, home, ros=ros, local=False, seed=seed, on_progress=say))

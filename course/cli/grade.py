"""`grade`: a class of submissions in one command."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from datetime import datetime, timezone
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from course.batch.arrivals import Arrivals
from course.batch.batch_plan import BatchPlan, plan_batch, remarks_on, sentence
from course.batch.class_page import TITLE, cleaner, decisions_in, gradebook
from course.batch.deadlines import NOT_KNOWN
from course.batch.intake.packed import differences
from course.batch.results import (
    BatchSettings,
    Results,
    keep_packed,
    keep_people,
    keep_settings,
    packed_of,
    people_of,
    settings_of,
)
from course.batch.run import (
    EVIDENCE,
    WORK,
    Batch,
    BatchProgress,
    Rounds,
    alone_in,
    default_jobs,
    local_rounds,
    results_folder,
    run,
)
from course.cli import github
from course.cli.extras import extra
from course.cli.options import options_of
from course.cli.session import GradingJobs, course_of
from course.cli.signals import ended_cleanly
from course.cli.usage import examples, spoken, typed
from course.errors import ExitCode, MissingHere, StorageError, UsageError
from course.files import wipe, write_pieces
from course.isolation import Level
from course.isolation.levels import obstacle_to
from course.report import sanitize
from course.report.activity import Show, progress
from course.report.batch import GradingTally, SubmissionRow, line_of, render_end, render_plan
from course.report.console import error_console, open_console, put, put_prose
from course.report.gradebook.class_files import write_reports
from course.report.gradebook.gradescope import as_text
from course.report.gradebook.sheets import sheets
from course.report.problem import render_problem

if TYPE_CHECKING:
    from rich.console import Console

    from course.batch.gradings import Graded
    from course.batch.intake import Found
    from course.content import Course, Exercise
    from course.model.gradebook import Gradebook
    from course.report.gradebook.cleaning import Cleaner


# How many of the new arrivals are named.
_NAMED = 5
_FILES = (
    ("results.csv", "points, for a gradebook"),
    ("feedback/", "a letter to each learner"),
    ("results.json, junit.xml, gradescope/", "for other programs"),
    ("grades.sqlite3, evidence/", "every check, and the recordings"),
)


@dataclass(frozen=True)
class ClassRequest:
    """The request of the command line, with absolute paths. exercises: names; empty means all found."""

    submissions: Path
    exercises: Sequence[str]
    out: Path
    single: bool = False
    course: Path | None = None
    roster: Path | None = None
    title: str = ""
    complete: bool = True
    names: str = "strict"

    def plan(self, course: Course, opened: Path, arrivals: Arrivals | None = None) -> BatchPlan:
        """What was found. opened: a folder for opened archives. Raises UsageError and StorageError."""
        of = partial(plan_batch, self.submissions, opened, course, self.exercises)
        of = partial(of, complete=self.complete, lenient=self.names == "lenient")
        return of(single=self.single, roster=self.roster, arrivals=arrivals)


@dataclass(frozen=True)
class Execution:
    """Where to grade. jobs: gradings at once, None for the default. contained: refuse to run uncontained.

    cluster: address of a Dask scheduler, `local` for one of our own, None for this machine's own pool.
    """

    jobs: int | None = None
    contained: bool = True
    cluster: str | None = None
    security: Path | None = None


def say_damaged(damaged: Sequence[tuple[str, str]], what_next: str) -> None:
    """damaged: person and exercise of each such grading."""
    for person, exercise in damaged:
        _say(error_console(), f"The stored result of {person} for {exercise} is damaged: {what_next}")


def look(course: Course, asked: ClassRequest) -> None:
    """Show what would be graded, and write nothing to the results folder."""
    with tempfile.TemporaryDirectory(prefix="ros2course-look-") as opened:
        _show(asked.plan(course, Path(opened)))


def grade_class(
    course: Course,
    asked: ClassRequest,
    graders: Execution,
    gradescope: Path | None,
    arrivals: Arrivals | None = None,
) -> bool:
    """Grade, and write the reports. Returns False if an error of ours kept something from being judged.

    arrivals: grade what is complete each time something comes, until a signal ends it.
    """
    with results_folder(asked.out) as results:
        say_damaged(results.drop_damaged(), "it is graded again.")
        try:
            with ended_cleanly() as again:
                _wait_for(arrivals)
                _grade_found(course, asked, graders, gradescope, results, again, arrivals)
                told = ""
                while arrivals:
                    _wait_for(arrivals, quiet=bool(told))
                    try:
                        _grade_found(course, asked, graders, gradescope, results, again, arrivals)
                        told = ""
                    except UsageError as error:  # such as a typo in deadlines.yaml, until it is corrected
                        told = _tell(error, told)
                        arrivals.forget_fresh()
        except KeyboardInterrupt:
            put(error_console(), "Stopped. The same command continues from here.")
            raise
        return "our error" not in results.verdicts()


def _wait_for(arrivals: Arrivals | None, *, quiet: bool = False) -> None:
    if arrivals:
        if not quiet:
            put(error_console(), "Waiting for submissions. Ctrl+C ends it.")
        arrivals.wait()


def _tell(error: UsageError, before: str) -> str:
    """Print a message only once."""
    if error.what != before:
        render_problem(error_console(), error.what, spoken(error.next_step or ""))
    return error.what


def _grade_found(
    course: Course,
    asked: ClassRequest,
    graders: Execution,
    gradescope: Path | None,
    results: Results,
    again: Callable[[], None],
    arrivals: Arrivals | None,
) -> None:
    """Grade the submissions that are there now. again: see `signals`."""
    try:
        planned = asked.plan(course, asked.out / WORK / "opened", arrivals)
        if not arrivals:
            _show(planned)
        decisions_in(asked.out, planned.people, planned.exercises)  # report typos before anything is graded
        if arrivals:
            _say(open_console(), _arrived(arrivals, planned))
        _note(results, planned, asked, graders.contained, datetime.now(timezone.utc))
        batch = Batch(asked.out, planned, graders.jobs or default_jobs(), asked.course, graders.contained)
        console = error_console()
        with progress(console) as show, _rounds(graders, asked, console, again) as rounds:
            teller = _Teller(show, again)
            run(batch, results, teller, rounds or local_rounds(batch.jobs, teller.doing))
    finally:
        wipe(asked.out / WORK)
    book, clean = _book(results, planned.exercises, settings_of(results), asked.out)
    write_reports(asked.out, book, clean)
    _hand_over(book, clean, planned.found[0] if asked.single else None, asked, gradescope)
    _say_end(results, asked.out, () if arrivals else _FILES)
    _say_different(results)
    _say_unknown(book)


def _arrived(arrivals: Arrivals, planned: BatchPlan) -> str:
    names = sorted(arrivals.fresh)
    more = f" and {len(names) - _NAMED} more" if len(names) > _NAMED else ""
    told = f"Complete: {', '.join(names[:_NAMED])}{more}." if names else "Something was removed."
    held = ", ".join(person.id for person in planned.held)
    return f"{told} Still being written: {held}." if held else told


def report_again(course: Course, results: Results, out: Path) -> None:
    """Write the reports again, from the stored results."""
    asked = settings_of(results)
    exercises = [course.exercise(name) for name in asked.exercises]
    write_reports(out, *_book(results, exercises, asked, out))


def grade_again(course: Course, out: Path, root: Path | None) -> bool:
    """Grade what is missing in the results, with the settings of the first run; see `grade_class`."""
    with results_folder(out) as results:
        before = settings_of(results)
    of = (before.submissions, before.wanted, out, before.single, root)
    asked = ClassRequest(*of, before.roster, before.title, before.complete, before.names)
    return grade_class(course, asked, Execution(contained=before.contained), None)


def _note(
    results: Results, planned: BatchPlan, asked: ClassRequest, contained: bool, began: datetime
) -> None:
    exercises = tuple(exercise.id for exercise in planned.exercises)
    of = (asked.submissions, tuple(asked.exercises), exercises, asked.single, contained, began)
    keep_settings(results, BatchSettings(*of, asked.roster, asked.title, asked.complete, asked.names))
    held = [person.id for person in planned.held]
    keep_people(results, planned.people, held)
    packed = {found.person.id: found.packed for found in planned.found if found.packed}
    keep_packed(results, packed, held)


@contextmanager
def _rounds(
    graders: Execution, asked: ClassRequest, console: Console, again: Callable[[], None]
) -> Iterator[Rounds | None]:
    """The workers that grade: those of a cluster, or None for this machine's. again: see `signals`."""
    if graders.cluster is None:
        yield None
        return
    of = (graders.cluster, graders.security, asked.course, graders.contained, graders.jobs)
    with extra("cluster").cluster_rounds(*of, partial(_say, console), again) as rounds:
        yield rounds


def _say(console: Console, text: str) -> None:
    put_prose(console, sanitize.paragraph(text))


class _Teller:
    """Shows progress on the terminal. show: from `activity.progress`. again: see `signals`."""

    def __init__(self, show: Show, again: Callable[[], None]) -> None:
        self._show = show
        self._again = again
        self._tally: GradingTally

    def doing(self, text: str) -> None:
        """Show only builds, which may take minutes. From any thread."""
        if text.startswith("Building "):
            self._show(self._tally, None, text[0].lower() + text[1:])

    def __call__(self, state: BatchProgress, graded: Graded | None) -> None:
        if graded is None:
            self._tally = GradingTally(state.total, state.before)
            self._show(self._tally, None)
        else:
            self._tally.add(graded.result)
            self._show(self._tally, line_of(graded.unit.person, graded.result))
        self._again()


def _show(planned: BatchPlan) -> None:
    remarks = [sentence(finding) for finding in planned.findings]
    render_plan(open_console(), [_row(planned, place) for place in range(len(planned.found))], remarks)


def _row(planned: BatchPlan, place: int) -> SubmissionRow:
    found = planned.found[place]
    exercises = [exercise.id for exercise in planned.exercises if planned.grades(found, exercise)]
    person = found.person
    return SubmissionRow(person.id, person.name, found.source, found.kind.value, exercises, remarks_on(found))


def _book(
    results: Results, exercises: Sequence[Exercise], asked: BatchSettings, out: Path
) -> tuple[Gradebook, Cleaner]:
    """The results for reports, and the cleaner that removes what reports must not contain."""
    decisions = decisions_in(out, people_of(results), exercises)
    of = (asked.title or TITLE, exercises, asked.began, datetime.now(timezone.utc), decisions)
    return gradebook(results, *of), cleaner(out, asked.submissions)


def _hand_over(
    book: Gradebook, clean: Cleaner, single: Found | None, asked: ClassRequest, file: Path | None
) -> None:
    """Pass the results on to our caller: Gradescope's harness (`file`), or a step of GitHub Actions."""
    if file:
        write_pieces(file.absolute(), [as_text(next(sheets(book, clean)))])
    github.hand_over(book, clean, single, asked.submissions, os.environ)


def _say_end(results: Results, out: Path, told: Sequence[tuple[str, str]]) -> None:
    shown = min(os.path.relpath(out), str(out), key=len)
    files = [(f"{shown}/{name}", what) for name, what in told]
    render_end(open_console(), sorted(results.verdicts().items()), files)


def _say_different(results: Results) -> None:
    """Name the people whose own check had a different result."""
    for person, packed in packed_of(results).items():
        for said in differences(packed, (one.result for one in results.gradings(person))):
            _say(error_console(), f"{person}: {said}")


def _say_unknown(book: Gradebook) -> None:
    """Name the people whose submission time is unknown."""
    late = ((graded.person, graded.lateness) for graded in book.graded)
    people = [person.name or person.id for person, found in late if found and found.words.endswith(NOT_KNOWN)]
    if people:
        put(error_console())
        told = f"Submission times are not known, so lateness cost no points, for: {', '.join(people)}."
        _say(error_console(), f"{told} Write the times into deadlines.yaml, under handed_in.")


# Instead of a scheduler's address: workers on this machine.
LOCAL = "local"

EXAMPLES = examples(
    ("grade class/", "everything it finds"),
    ("grade class.zip --dry-run", "only show what is found"),
    ("grade class.csv --exercises 18,20-client", "a roster, two exercises"),
    ("grade class/ --watch", "also what arrives later"),
    ("grade class/ --cluster tcp://host:8786", "on Dask workers"),
)


def grade(
    ctx: typer.Context,
    submissions: Annotated[
        Path, typer.Argument(metavar="SUBMISSIONS", help="A folder, an archive, or a CSV roster.")
    ],
    exercises: Annotated[
        str,
        typer.Option("--exercises", metavar="ID,...", help="Only these; by default, all that are found."),
    ] = "",
    jobs: GradingJobs = None,
    roster: Annotated[
        Path | None, typer.Option("--roster", metavar="CSV", help="The class: your LMS's gradebook or list.")
    ] = None,
    title: Annotated[
        str, typer.Option("--title", metavar="TEXT", help="The name of the assignment, for reports.")
    ] = "",
    complete: Annotated[
        bool, typer.Option(help="Use the course's packages where a submission lacks one.")
    ] = True,
    names: Annotated[
        Literal["strict", "lenient"],
        typer.Option("--names", help="lenient: a different name costs one point, not the exercise."),
    ] = "strict",
    out: Annotated[Path, typer.Option("--out", metavar="DIR", help="The folder for the results.")] = Path(
        "grades"
    ),
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Show what is found, and grade nothing.")
    ] = False,
    watch: Annotated[
        bool, typer.Option("--watch", help="Keep grading what arrives in the folder, until Ctrl+C.")
    ] = False,
    single: Annotated[bool, typer.Option("--single", help="SUBMISSIONS is one submission.")] = False,
    gradescope: Annotated[
        Path | None,
        typer.Option("--gradescope", metavar="FILE", help="With --single: Gradescope's results.json."),
    ] = None,
    no_sandbox: Annotated[
        bool, typer.Option("--no-sandbox", help="Run submissions even if they cannot be contained.")
    ] = False,
    cluster: Annotated[
        str | None,
        typer.Option(
            "--cluster", metavar="ADDRESS", help="Grade on the workers of this Dask scheduler, or `local`."
        ),
    ] = None,
    cluster_security: Annotated[
        Path | None,
        typer.Option(
            "--cluster-security", metavar="FILE", help="With --cluster: a file of Dask settings for TLS."
        ),
    ] = None,
) -> None:
    """Grade a class of submissions.

    Each result is stored at once. If the command is stopped or killed, the same
    command continues where it stopped. Submissions run contained: without a
    network, without access to this machine's files, and with limits.
    """
    if gradescope and not single:
        raise UsageError("--gradescope is for one submission.", "Add --single.")
    if watch and (single or dry_run):
        raise UsageError("--watch is for a folder that submissions arrive in.", "Leave it out.")
    if cluster:
        _look_at_cluster(cluster, cluster_security)
    elif cluster_security:
        raise UsageError("--cluster-security is for a cluster.", "Add --cluster.")
    if not (no_sandbox or dry_run) and cluster in (None, LOCAL):
        _look_at_machine()
    wanted = [name.strip() for name in exercises.split(",") if name.strip()]
    options = options_of(ctx)
    listed = roster.absolute() if roster else None
    of = (submissions.absolute(), wanted, out.absolute(), single, options.course)
    asked = ClassRequest(*of, listed, title, complete, names)
    course = course_of(options)
    if dry_run:
        look(course, asked)
        return
    graders = Execution(jobs, not no_sandbox, cluster, cluster_security)
    is_new = not asked.out.exists()
    try:
        arrivals = Arrivals(asked.submissions) if watch else None
        sound = grade_class(course, asked, graders, gradescope, arrivals)
    except UsageError:
        if is_new:
            remove_if_unused(asked.out)
        raise
    raise typer.Exit(ExitCode.PASSED if sound else ExitCode.OUR_FAULT)


def remove_if_unused(out: Path) -> None:
    """Remove a results folder without results, unless somebody is grading into it."""
    with suppress(UsageError, StorageError), alone_in(out):
        if not (out / EVIDENCE).exists() and not _holds_gradings(out):
            wipe(out)


def _holds_gradings(out: Path) -> bool:
    try:
        with Results.look(out) as results:
            return bool(results.verdicts())
    except UsageError:
        return False


def _look_at_cluster(cluster: str, security: Path | None) -> None:
    extra("cluster")
    if security and cluster == LOCAL:
        raise UsageError(f"--cluster {LOCAL} creates its own keys.", "Leave --cluster-security out.")


def _look_at_machine() -> None:
    obstacle = obstacle_to(Level.CONTAINED)
    if obstacle is not None:
        step = "--no-sandbox grades anyway; use it only for programs that you trust."
        raise MissingHere(
            f"Submissions cannot be contained on this machine: {obstacle}.",
            f"`{typed('doctor')}` shows how to fix that. {step}",
        )

"""What `grade` does with a class, and shows of it."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import datetime, timezone
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from course.cli.ending import ended_cleanly

if TYPE_CHECKING:
    from rich.console import Console

    from course.batch.intake import Found
    from course.batch.model import Graded
    from course.batch.plan import Planned
    from course.batch.results import Results
    from course.batch.run import Progress, Rounds
    from course.content import Course, Exercise
    from course.report.batch import Row, Tally
    from course.report.gradebook.cleaning import Cleaner
    from course.report.gradebook.model import Gradebook

_FILES = (
    ("results.csv", "points, for a gradebook"),
    ("feedback/", "a letter to each learner"),
    ("results.json, junit.xml, gradescope/", "for other programs"),
    ("grades.sqlite3, evidence/", "every check, and the recordings"),
)
_TITLE = "ros2course"


@dataclass(frozen=True)
class Asked:
    """What the command line asks for; paths are absolute. exercises: names, all that are found if none."""

    submissions: Path
    exercises: Sequence[str]
    out: Path
    single: bool = False
    course: Path | None = None


@dataclass(frozen=True)
class Graders:
    """Who grades. jobs: gradings at once, None for as many as suit. contained: refuse whatever is not.

    cluster: address of a Dask scheduler, `local` for one of our own, None for this machine's own pool.
    """

    jobs: int | None = None
    contained: bool = True
    cluster: str | None = None
    security: Path | None = None


def look(course: Course, asked: Asked) -> None:
    """Show what would be graded; nothing is written to the results' folder."""
    from course.batch.plan import plan

    with tempfile.TemporaryDirectory(prefix="ros2course-look-") as opened:
        _show(plan(asked.submissions, Path(opened), course, asked.exercises, single=asked.single))


def grade_class(course: Course, asked: Asked, graders: Graders, gradescope: Path | None) -> bool:
    """Grade, and write the reports. False when something could not be judged through a fault of ours."""
    from course.batch.plan import plan
    from course.batch.run import WORK, Batch, default_jobs, results_folder, run
    from course.report.batch import progress
    from course.report.console import error_console, put
    from course.report.gradebook.folder import write_reports
    from course.rosenv.files import wipe

    with results_folder(asked.out) as results:
        opened = asked.out / WORK / "opened"
        try:
            planned = plan(asked.submissions, opened, course, asked.exercises, single=asked.single)
            _show(planned)
            began = datetime.now(timezone.utc)
            _note(results, planned, asked, graders.contained, began)
            jobs = graders.jobs or default_jobs()
            batch = Batch(asked.out, planned, jobs, asked.course, graders.contained)
            console = error_console()
            with (
                ended_cleanly() as again,
                progress(console) as show,
                _rounds(graders, asked, console, again) as rounds,
            ):
                run(batch, results, _Teller(show, again), rounds)
        except KeyboardInterrupt:
            put(error_console(), "Stopped. The same command goes on from here.")
            raise
        finally:
            wipe(asked.out / WORK)
        book, clean = _book(results, planned.exercises, asked.submissions, asked.out, began)
        write_reports(asked.out, book, clean)
        _hand_over(book, clean, planned.found[0] if asked.single else None, asked, gradescope)
        _say_end(results, asked.out)
        return "our error" not in results.verdicts()


def report_again(course: Course, results: Results, out: Path) -> None:
    """Write the reports anew, from what is stored."""
    from course.batch.noted import noted
    from course.report.gradebook.folder import write_reports

    asked = noted(results)
    exercises = [course.exercise(name) for name in asked.exercises]
    write_reports(out, *_book(results, exercises, asked.submissions, out, asked.began))


def grade_again(course: Course, out: Path, root: Path | None) -> bool:
    """Grade what is missing among the results, as it was asked for the first time; see `grade_class`."""
    from course.batch.noted import noted
    from course.batch.run import results_folder

    with results_folder(out) as results:
        before = noted(results)
    asked = Asked(before.submissions, before.wanted, out, before.single, root)
    return grade_class(course, asked, Graders(contained=before.contained), None)


def _note(results: Results, planned: Planned, asked: Asked, contained: bool, began: datetime) -> None:
    from course.batch.noted import Noted, note

    exercises = tuple(exercise.id for exercise in planned.exercises)
    wanted = tuple(asked.exercises)
    note(results, Noted(asked.submissions, wanted, exercises, asked.single, contained, began))


@contextmanager
def _rounds(
    graders: Graders, asked: Asked, console: Console, again: Callable[[], None]
) -> Iterator[Rounds | None]:
    """What grades: a cluster's workers, or None for those of this machine. again: see `ending`."""
    if graders.cluster is None:
        yield None
        return
    from course.batch.cluster.connect import scheduler_at
    from course.batch.cluster.fitness import wanted
    from course.batch.cluster.rounds import Cluster

    like_this = wanted(asked.course, graders.contained)
    with scheduler_at(graders.cluster, graders.security) as client:
        say = partial(_say, console)
        yield Cluster(client, like_this, say, graders.jobs, again)


def _say(console: Console, text: str) -> None:
    from course.report import safe
    from course.report.console import put_prose

    put_prose(console, safe.paragraph(text))


class _Teller:
    """Tells the terminal how far it is. show: as `report.batch.progress` yields it. again: see `ending`."""

    def __init__(self, show: Callable[[Tally, str | None], None], again: Callable[[], None]) -> None:
        self._show = show
        self._again = again
        self._tally: Tally

    def __call__(self, state: Progress, graded: Graded | None) -> None:
        from course.report.batch import Tally, line_of

        if graded is None:
            self._tally = Tally(state.total, state.before)
            self._show(self._tally, None)
        else:
            self._tally.add(graded.result)
            self._show(self._tally, line_of(graded.unit.person, graded.result))
        self._again()


def _show(planned: Planned) -> None:
    from course.report.batch import render_plan
    from course.report.console import open_console

    remarks = [finding.what for finding in planned.findings]
    render_plan(open_console(), [_row(planned, place) for place in range(len(planned.found))], remarks)


def _row(planned: Planned, place: int) -> Row:
    from course.batch.plan import remarks_on
    from course.report.batch import Row

    found = planned.found[place]
    exercises = [exercise.id for exercise in planned.exercises if planned.grades(found, exercise)]
    person = found.person
    return Row(person.id, person.name, found.source, found.kind.value, exercises, remarks_on(found))


def _book(
    results: Results, exercises: Sequence[Exercise], submissions: Path, out: Path, began: datetime
) -> tuple[Gradebook, Cleaner]:
    """The results as reports take them, and what keeps from reports what must not be in them."""
    from course.batch.gradebook import cleaner, gradebook

    book = gradebook(results, _TITLE, exercises, began, datetime.now(timezone.utc))
    return book, cleaner(out, submissions)


def _hand_over(
    book: Gradebook, clean: Cleaner, single: Found | None, asked: Asked, file: Path | None
) -> None:
    """To those who called us: Gradescope's harness (`file`), a step of GitHub Actions."""
    from course.cli import github
    from course.report.gradebook.files import write
    from course.report.gradebook.gradescope import as_text
    from course.report.gradebook.sheets import sheets

    if file:
        write(file.absolute(), [as_text(next(sheets(book, clean)))])
    github.hand_over(book, clean, single, asked.submissions, os.environ)


def _say_end(results: Results, out: Path) -> None:
    from course.report.batch import render_end
    from course.report.console import open_console

    files = [(f"{out.name}/{name}", what) for name, what in _FILES]
    render_end(open_console(), sorted(results.verdicts().items()), files)

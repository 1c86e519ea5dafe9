"""Grades a class, and continues where an earlier run ended, however it ended."""

from __future__ import annotations

import contextlib
import os
import shutil
import threading
from collections import Counter, deque
from collections.abc import Callable, Collection, Generator, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

import course
from course.arena.mystery_module import log_file
from course.batch.batch_plan import BatchPlan, submission_of
from course.batch.gradings import GRADINGS, Graded, GradingTask, NextTask, Unit
from course.batch.intake import Found, lay_out
from course.batch.pool import Pool, Say
from course.batch.repair import repair
from course.batch.results import Results
from course.content import Exercise, answers_file
from course.content.layout import STATE
from course.errors import CourseError, UsageError
from course.files import locked, sweep, wipe
from course.grading.attempts import deserves_another
from course.home.course_home import MARKER
from course.home.opening import Refused
from course.home.storage import storing
from course.model.feedback import Feedback
from course.model.result import Result, Verdict


class Homes:
    """Course homes in `folder`. kept: a folder for what regrading needs of them, besides recordings."""

    def __init__(self, folder: Path, kept: Path, found: Iterable[Found]) -> None:
        self._folder = folder
        self._kept = kept
        self._found: Mapping[str, Found] = {one.person.id: one for one in found}
        self._users: Counter[str] = Counter()
        self._one_at_a_time = threading.Lock()

    def take(self, unit: Unit, exercise: Exercise) -> Path:
        """The home in which the unit is graded. Raises StorageError and Refused."""
        home = self._folder / unit.person
        with self._one_at_a_time:
            if not self._users[unit.person]:
                wipe(home)
                with storing(f"the submission of {unit.person} cannot be put in place"):
                    home.parent.mkdir(parents=True, exist_ok=True)
                lay_out(self._found[unit.person], home)
            with storing(f"the answers of {unit.person} cannot be saved"):
                self._keep(unit, exercise, home)
            self._users[unit.person] += 1
        return home

    def give_back(self, unit: Unit) -> None:
        """Call this once for each `take`."""
        with self._one_at_a_time:
            self._users[unit.person] -= 1
            if not self._users[unit.person]:
                wipe(self._folder / unit.person)

    def _keep(self, unit: Unit, exercise: Exercise, home: Path) -> None:
        """Keep answers, the notes of `play`, and the seed that they depend on."""
        if not (exercise.questions or exercise.play):
            return
        acts = log_file(home / STATE, exercise.id).relative_to(home)
        for file in (Path(answers_file(exercise.id)), acts, Path(STATE, MARKER)):
            if (home / file).is_file():
                target = self._kept / unit.person / file
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(home / file, target)


WORK, EVIDENCE, ANSWERS = "work", "evidence", "answers"


@dataclass(frozen=True)
class Batch:
    """out: the results' folder. jobs: how many gradings at once. course: root of the course, None for ours.

    contained: refuse to run submissions uncontained.
    """

    out: Path
    planned: BatchPlan
    jobs: int
    course: Path | None = None
    contained: bool = True


@dataclass(frozen=True)
class BatchProgress:
    """total: how many units there are. before: how many of them an earlier run had graded."""

    total: int
    before: int


class Rounds(Protocol):
    """What grades a round of tasks: the workers of this machine, or those of a cluster."""

    def __call__(self, next_task: NextTask, *, waiting: int, alone: bool) -> Generator[Graded, None, None]:
        """Gradings as they come, until next_task gives None; whatever ends the iteration ends them.

        waiting: how many tasks there may be. alone: each needs a machine to itself.
        """


def default_jobs() -> int:
    """A grading mostly waits for messages, so four share a core without disturbing each other's timing.

    With more, bench/batch.py does not get faster, and more gradings must be repeated.
    """
    return 4 * len(os.sched_getaffinity(0))


@contextlib.contextmanager
def results_folder(out: Path) -> Iterator[Results]:
    """Open the results; nobody else can grade into them meanwhile. Raises UsageError and StorageError."""
    with alone_in(out):
        repair(out)
        with Results.open(out) as results:
            _sweep(out)
            yield results


def _sweep(out: Path) -> None:
    """Remove half-written reports and recordings. Trees that submissions left in WORK are not searched."""
    with storing(f"results cannot be saved in {out}"):
        for folder in (out, *out.glob("*/"), *out.glob(f"{EVIDENCE}/*/")):
            sweep(folder)


@contextlib.contextmanager
def alone_in(out: Path) -> Iterator[None]:
    """Inside this context, nobody else can grade into the folder. Raises UsageError and StorageError."""
    with storing(f"results cannot be saved in {out}"):
        stack = contextlib.ExitStack()
        try:
            stack.enter_context(locked(out / "lock", wait=False))
        except BlockingIOError:
            raise UsageError(
                f"Somebody else is grading into {out} right now.",
                "Wait until that ends, or name another --out.",
            ) from None
    with stack:
        yield


def run(
    batch: Batch,
    results: Results,
    on_progress: Callable[[BatchProgress, Graded | None], None],
    rounds: Rounds | None = None,
) -> None:
    """Grade what has not been graded yet; each result is in `results` before `on_progress` is called.

    rounds: what does the gradings; None for `batch.jobs` workers on this machine, which report nothing.
    Ctrl+C ends the gradings at once and cleanly; what was graded stays.
    """
    held = [person.id for person in batch.planned.held]
    results.enter([submission_of(found) for found in batch.planned.found], held)
    _forget_others(batch.out, {one.person for one in results.submissions()})
    done = results.done()
    units = list(batch.planned.units())
    todo = [unit for unit in units if (unit.person, unit.exercise) not in done]
    progress = BatchProgress(len(units), len(units) - len(todo))
    on_progress(progress, None)
    work = batch.out / WORK / "homes"
    try:
        homes = Homes(work, batch.out / ANSWERS, batch.planned.found)
        for graded in _Schedule(batch, homes, todo, rounds or local_rounds(batch.jobs)).graded():
            results.record(graded, course.__version__, _evidence_of(batch, graded.unit))
            on_progress(progress, graded)
    finally:
        wipe(work)


def _forget_others(out: Path, people: Collection[str]) -> None:
    """Remove the recordings and answers of people who are no longer in the class."""
    for folder in (out / EVIDENCE, out / ANSWERS):
        for path in folder.iterdir() if folder.is_dir() else ():
            if path.name not in people:
                wipe(path)


def local_rounds(jobs: int, say: Say = lambda text: None) -> Rounds:
    """Workers on this machine. say: called from several threads with what they are doing."""

    def rounds(next_task: NextTask, *, waiting: int, alone: bool) -> Generator[Graded, None, None]:
        return Pool(GRADINGS, 1 if alone else min(jobs, max(1, waiting)), next_task, say).results()

    return rounds


class _Schedule:
    """First everything, several at once; then, one by one, what could not be judged beside others."""

    def __init__(self, batch: Batch, homes: Homes, todo: list[Unit], rounds: Rounds) -> None:
        self._batch = batch
        self._rounds = rounds
        self._homes = homes
        self._waiting = deque(todo)
        self._later: deque[Unit] = deque()
        self._refused: list[Graded] = []
        self._exercises = {exercise.id: exercise for exercise in batch.planned.exercises}

    def graded(self) -> Iterator[Graded]:
        """Each unit once, with its last attempt."""
        yield from self._round(alone=False)
        while self._later:
            self._waiting, self._later = self._later, deque()
            yield from self._round(alone=True)

    def _round(self, *, alone: bool) -> Iterator[Graded]:
        graded_now = self._rounds(self._next, waiting=len(self._waiting), alone=alone)
        with contextlib.closing(graded_now) as found:
            for graded in found:
                self._homes.give_back(graded.unit)
                if deserves_another(graded.result, graded.unit.attempt):
                    self._later.append(graded.unit.again())
                else:
                    yield graded
        yield from self._refused
        self._refused = []

    def _next(self) -> GradingTask | None:
        while self._waiting:
            unit = self._waiting.popleft()
            try:
                home = self._homes.take(unit, self._exercises[unit.exercise])
            except (CourseError, Refused) as error:
                self._refused.append(not_laid(unit, error))
                continue
            evidence = self._batch.out / _evidence(unit)
            _clear(evidence)
            root = str(self._batch.course) if self._batch.course else None
            return GradingTask(unit, str(home), str(evidence), root, self._batch.contained)
        return None


def _clear(evidence: Path) -> None:
    """Remove files of another attempt, or of one that was killed."""
    for file in evidence.parent.glob(f"*{evidence.name}*"):
        file.unlink(missing_ok=True)


def not_laid(unit: Unit, error: CourseError | Refused) -> Graded:
    """The result of a unit that could not even be started: an error of ours."""
    if isinstance(error, Refused):
        fault = Feedback(summary=error.finding.what, advice=error.finding.advice)
    else:
        fault = Feedback(summary=error.what, advice=error.next_step)
    return Graded(unit, Result(unit.exercise, Verdict.OUR_ERROR, fault=fault), 0.0)


def _evidence(unit: Unit) -> str:
    return f"{EVIDENCE}/{unit.person}/{unit.exercise}.mcap"


def _evidence_of(batch: Batch, unit: Unit) -> str | None:
    return _evidence(unit) if (batch.out / _evidence(unit)).is_file() else None

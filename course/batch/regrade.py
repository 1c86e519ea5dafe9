"""Marks a graded class again with the current checks, without running any submission."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import course as package
from course.batch.gradings import Graded, Unit
from course.batch.results import Results, StoredGrading
from course.batch.run import ANSWERS
from course.batch.worker import seed_of
from course.content import Course, Exercise
from course.errors import OurFault, UsageError
from course.grading.attempts import doubt_of
from course.grading.judge.judges import StoredRecording, rejudge
from course.grading.judge.regraded import lacks, moves, regraded
from course.grading.load import runs_programs
from course.grading.protocol import Judged, Unjudged, UnjudgedCause
from course.model.result import Doubt, Result, Verdict
from course.report.batch import Moved

Key = tuple[str, str]


@dataclass(frozen=True)
class Lacking:
    """A grading that stays as it was, because the evidence is not enough. why: one line."""

    person: str
    exercise: str
    why: str


@dataclass(frozen=True)
class Regraded:
    """The outcome. judged: how many gradings were judged again."""

    judged: int
    moved: tuple[Moved, ...]
    lacking: tuple[Lacking, ...]


def regrade(
    out: Path,
    results: Results,
    course: Course,
    on_progress: Callable[[int, int], None],
    *,
    jobs: int | None,
    dry_run: bool = False,
) -> Regraded:
    """Judge everything in the results' folder again. Either all marks change, or none.

    on_progress: gets the numbers of gradings done and in total. dry_run: nothing is stored.
    Raises UsageError if an exercise is no longer in the course.
    """
    return _Regrading(out, results, course, dry_run).run(on_progress, jobs)


class _Regrading:
    def __init__(self, out: Path, results: Results, course: Course, dry_run: bool) -> None:
        self._dry_run = dry_run
        self._out = out
        self._results = results
        self._names = {one.person: one.name for one in results.submissions()}
        self._stored: dict[Key, StoredGrading] = {}
        for person in self._names:
            for stored in results.gradings(person):
                self._stored[person, stored.unit.exercise] = stored
        sound = {exercise for (_, exercise), stored in self._stored.items() if not stored.damaged}
        self._exercises = {name: _exercise(course, name) for name in sorted(sound)}
        self._moved: list[Moved] = []
        self._lacking: list[Lacking] = []

    def run(self, on_progress: Callable[[int, int], None], jobs: int | None) -> Regraded:
        done = 0
        with self._results.writing():
            for key, judged in self._judged(jobs):
                self._take(key, judged)
                done += 1
                on_progress(done, len(self._stored))
        self._moved.sort(key=lambda one: (one.name, one.person, one.exercise))
        self._lacking.sort(key=lambda one: (one.person, one.exercise))
        return Regraded(done, tuple(self._moved), tuple(self._lacking))

    def _judged(self, jobs: int | None) -> Iterator[tuple[Key, Judged | Unjudged | None]]:
        """None for an exercise with questions only, because its answers are the only evidence."""
        recorded = []
        for key, stored in self._stored.items():
            if stored.damaged:
                yield key, Unjudged(UnjudgedCause.MISSING, "Its stored result is damaged.")
                continue
            exercise = self._exercises[key[1]]
            if not runs_programs(exercise):
                yield key, None
            elif stored.evidence:
                recorded.append(StoredRecording(key, exercise, self._out / stored.evidence))
            elif stored.result.verdict is not Verdict.NOT_APPLICABLE:
                yield key, Unjudged(UnjudgedCause.MISSING, "Nothing was recorded.")
        yield from rejudge(recorded, jobs=jobs)

    def _take(self, key: Key, judged: Judged | Unjudged | None) -> None:
        person, exercise = key
        stored = self._stored[key]
        if isinstance(judged, Unjudged):
            self._lacking.append(Lacking(person, exercise, judged.what))
            return
        answers = self._out / ANSWERS / person
        judgment = judged.judgment if judged else None
        if judgment and judgment.fault:
            step = "Fix the grader. No marks were changed."
            raise OurFault(f"{exercise} cannot be judged: {judgment.fault.summary}", step)
        seed = seed_of(person, answers)
        after = regraded(stored.result, self._exercises[exercise], judgment, answers, seed)
        why = lacks(stored.result, after, judged) if judged else None
        if doubt_of(after) is Doubt.BUSY:
            why = "The machine was too busy when it was recorded."
        if why is not None:
            self._lacking.append(Lacking(person, exercise, why))
        else:
            self._record(stored, after)

    def _record(self, stored: StoredGrading, after: Result) -> None:
        if after == stored.result:
            return
        unit, before = stored.unit, stored.result
        graded = Graded(unit, after, stored.seconds)
        if not self._dry_run:
            self._results.record(graded, package.__version__, stored.evidence)
        what = moves(before, after)
        if what:
            marks = (before.points, after.points, before.max_points, after.max_points)
            self._moved.append(Moved(unit.person, self._names[unit.person], unit.exercise, *marks, what))


def _exercise(course: Course, name: str) -> Exercise:
    found = next((exercise for exercise in course.exercises() if exercise.id == name), None)
    if found is None:
        step = "Name the course that graded it: ros2course --course DIR regrade ..."
        raise UsageError(f"The course no longer has an exercise {name}.", step)
    return found


def forget_lacking(results: Results, lacking: tuple[Lacking, ...]) -> None:
    """Forget these gradings, so that the next `grade` does them again."""
    with results.writing():
        for one in lacking:
            results.forget(Unit(one.person, one.exercise))

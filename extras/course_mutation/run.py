"""Mutates graders, one exercise after the other; the mutants of one exercise run at the same time."""

from __future__ import annotations

import contextlib
import os
import signal
import tempfile
import time
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import closing

from course.child import Child
from course.content import Course, Exercise
from course.errors import CourseError, MissingHere, OurFault
from course.grading.judge.judges import start_judging
from course.grading.load import runs_programs
from course.model import codec, replace
from course_mutation.model import (
    Case,
    Change,
    Ended,
    Evidence,
    Fate,
    Judged,
    Mutant,
    Mutated,
    Mutation,
    OfExercise,
    Step,
)
from course_mutation.mutants import mutants
from course_mutation.recordings import Found, Recorded, recordings

# Most programs wait most of the time, as in `grade`.
_RUNS_A_CORE = 3

OnProgress = Callable[[Step], None]


def mutate(
    course: Course,
    exercises: Sequence[Exercise],
    *,
    jobs: int | None = None,
    on_progress: OnProgress = lambda step: None,
) -> Mutation:
    """Weaken the graders of these exercises, one thing at a time, and judge their proofs' recordings by each.

    This leaves out exercises without a grader (only questions), and those about the learner's own machine,
    which have no solution in files. jobs: processes at once; by default the number of cores, and three times
    as many to run programs. Errors of one exercise go into its `problems`. Raises MissingHere if this
    machine lacks something.
    """
    found = [
        _Exercise(course, exercise, jobs, on_progress).mutated()
        for exercise in exercises
        if not exercise.local_only and runs_programs(exercise)
    ]
    return Mutation(tuple(known_elsewhere(found)))


class _Exercise:
    def __init__(self, course: Course, exercise: Exercise, jobs: int | None, tell: OnProgress) -> None:
        self._course = course
        self._exercise = exercise
        cores = len(os.sched_getaffinity(0))
        self._runs, self._judges = jobs or _RUNS_A_CORE * cores, jobs or cores
        self._tell = tell

    def mutated(self) -> OfExercise:
        try:
            every = mutants(self._exercise)
            return self._of(every)
        except MissingHere:
            raise
        except CourseError as error:
            return OfExercise(self._exercise.id, problems=(" ".join(str(error).split()),))

    def _of(self, every: Sequence[Mutant]) -> OfExercise:
        began = time.monotonic()
        found = recordings(self._course, self._exercise, self._runs, self._recorded)
        recorded = time.monotonic()
        ended, problems = self._judge(every, found)
        return OfExercise(
            exercise=self._exercise.id,
            judged=tuple(sorted(ended, key=lambda one: (one.mutant.line, one.mutant.change.start))),
            problems=(*found.problems, *problems),
            recorded=found.made,
            kept=len(found.recorded) - found.made,
            recording=recorded - began,
            judging=time.monotonic() - recorded,
        )

    def _judge(self, every: Sequence[Mutant], found: Found) -> tuple[list[Judged], tuple[str, ...]]:
        ended: list[Judged] = []
        problems: tuple[str, ...] = ()
        if not found.recorded or not every:
            return ended, problems
        self._tell(Step(self._exercise.id, "judging", 0, len(every)))
        with closing(judged(self._course, self._exercise, every, found.recorded, self._judges)) as answers:
            for answer in answers:
                if isinstance(answer, tuple):
                    problems = answer
                else:
                    ended.append(answer)
                    self._tell(Step(self._exercise.id, "judging", len(ended), len(every), answer))
        return ended, problems

    def _recorded(self, done: int, total: int) -> None:
        self._tell(Step(self._exercise.id, "recording", done, total))


def known_elsewhere(every: Sequence[OfExercise]) -> Iterator[OfExercise]:
    """The results, where a mutant of shared code counts as noticed if any exercise notices it."""
    noticed: dict[tuple[object, Change], str] = {}
    for one in every:
        for judged_ in one.judged:
            if judged_.fate is not Fate.SURVIVED:
                noticed.setdefault((judged_.mutant.file, judged_.mutant.change), one.exercise)
    for one in every:
        yield replace(one, judged=tuple(_also(judged_, noticed) for judged_ in one.judged))


def _also(one: Judged, noticed: dict[tuple[object, Change], str]) -> Judged:
    where = noticed.get((one.mutant.file, one.mutant.change))
    if one.fate is not Fate.SURVIVED or where is None:
        return one
    return replace(one, fate=Fate.KILLED, by=f"noticed in {where}")


_WORKER = "course_mutation.worker"
# Nearly all mutants need 0.1 s.
SECONDS = 10.0
_LOG = 2000


def judged(
    course: Course,
    exercise: Exercise,
    mutants: Sequence[Mutant],
    recorded: Sequence[Recorded],
    jobs: int,
    seconds: float = SECONDS,
) -> Generator[Judged | tuple[str, ...], None, None]:
    """First the proofs that fail with the unchanged grader; then each mutant, in no particular order.

    mutants: at least one. seconds: CPU time that a mutant may use. To stop early, close the iterator, which
    ends all processes. Raises OurFault if nothing can be judged.
    """
    with tempfile.TemporaryDirectory(prefix="ros2course-mutants-") as folder:
        case = Case(
            course=str(course.root),
            exercise=exercise.id,
            folder=folder,
            text=mutants[0].text.decode(),
            evidence=tuple(Evidence(one.proof, str(one.file), str(one.result)) for one in recorded),
            mutants=tuple(_mutated(mutant) for mutant in mutants),
            jobs=jobs,
            seconds=seconds,
        )
        for line in _answers(case):
            answer: Ended | tuple[str, ...] = codec.from_json(line, Ended | tuple[str, ...], "this line")
            yield (
                answer if isinstance(answer, tuple) else Judged(mutants[answer.index], answer.fate, answer.by)
            )


def _mutated(mutant: Mutant) -> Mutated:
    change = mutant.change
    return Mutated(change.start, change.end, change.new.decode(), mutant.checks)


def _answers(case: Case) -> Iterator[bytes]:
    with contextlib.ExitStack() as stack:
        log = stack.enter_context(tempfile.TemporaryFile("w+", errors="replace"))
        worker = start_judging(_WORKER, log)
        stack.callback(_end, worker)
        worker.tell(case)
        count = 0
        while (lines := worker.read()) is not None:
            count += len(lines)
            yield from lines
        if worker.process.wait() != 0 or count != len(case.mutants) + 1:
            log.seek(0)
            raise OurFault(f"mutants of {case.exercise} cannot be judged: {log.read()[-_LOG:].strip()}")


def _end(worker: Child) -> None:
    """End the worker and the mutants' processes, so that none of them writes a file any more."""
    if worker.process.poll() is None:
        os.killpg(worker.process.pid, signal.SIGKILL)  # it leads its own process group
    while worker.read() is not None:  # all of them hold the other end
        pass
    worker.close()

"""Mutates the graders of exercises, one exercise after the other; the mutants of one at the same time."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing
from dataclasses import replace

from course.content import Course, Exercise
from course.errors import CourseError, MissingHere
from course.grading.load import runs_programs
from course.validate.mutation.model import Change, Fate, Judged, Mutant, Mutation, OfExercise, Step
from course.validate.mutation.mutants import mutants
from course.validate.mutation.recordings import Found, recordings
from course.validate.mutation.trial import judged

# Of what is run, most waits for most of the time: as for `grade`.
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

    Exercises without a grader of their own (questions alone), and those about the learner's own machine,
    which no tree of files solves, are left out. jobs: processes at once; by default as many as there are
    cores, and three times as many where something is run. What is wrong with one exercise is among its
    `problems`. Raises MissingHere for what this machine lacks.
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
    """What several exercises use is proven when one of them notices."""
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

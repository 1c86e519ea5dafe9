"""What a graded class is: who, which exercises, and how each of them ended."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from datetime import datetime

from course.grading.result import Result


@dataclass(frozen=True)
class Person:
    """Who handed something in. `id`: unique in the gradebook (a roster's id, or the submission's name)."""

    id: str
    name: str = ""


@dataclass(frozen=True)
class GradedExercise:
    """One exercise that was asked for. max_points: what it brings when all of its checks apply."""

    id: str
    title: str
    max_points: float
    bonus: bool = False


@dataclass(frozen=True)
class Graded:
    """One submission and what became of it.

    source: what was handed in, as a name inside the folder of submissions; empty when nothing was.
    results: one for each exercise that was found in it; a missing one was not handed in.
    remarks: sentences about the submission as a whole, for the learner and the instructor.
    """

    person: Person
    source: str
    results: tuple[Result, ...] = ()
    remarks: tuple[str, ...] = ()


@dataclass(frozen=True)
class Gradebook:
    """A graded class.

    graded: can be walked more than once, and need not be in memory: an object whose `__iter__` reads
    one submission after another from where they are stored. Only results of the listed `exercises`
    are reported. began, ended: with a time zone. containment: how submissions were kept apart.
    """

    course: str
    exercises: tuple[GradedExercise, ...]
    graded: Iterable[Graded]
    began: datetime
    ended: datetime
    containment: str = ""

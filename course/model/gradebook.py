"""A graded class: who was graded, on which exercises, and with which results."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from datetime import datetime

from course.model.result import Result


@dataclass(frozen=True)
class Person:
    """Someone who handed something in.

    id: unique in the class, the same each time (a roster's id, or the submission's name). name: safe to show.
    late: what the LMS says; None if it says nothing. handed_in: when; None if unknown. Without a time zone,
    it is in the class's.
    group: empty for a person who works alone. graded_as: the id of the person whose submission counts for
    this one, too. renamed: ids of exercises in which files are graded as if they were named correctly.
    """

    id: str
    name: str = ""
    late: bool | None = None
    handed_in: datetime | None = None
    group: str = ""
    graded_as: str = ""
    renamed: tuple[str, ...] = ()


@dataclass(frozen=True)
class GradedExercise:
    """One exercise that was asked for. max_points: what it is worth if all of its checks apply."""

    id: str
    title: str
    max_points: float
    bonus: bool = False


@dataclass(frozen=True)
class HandMark:
    """A person's decision about a submission, or for the whole class, on top of the automatic verdicts.

    exercise: its id, "" for the submission as a whole. check: the id of one of its checks, "" for all of it.
    points: what is earned there instead of the automatic points. bonus: added to them; deducted if negative.
    excused: it does not count. comment: for the learner. label: the first words of the sentence about it.
    """

    exercise: str = ""
    check: str = ""
    points: float | None = None
    bonus: float = 0.0
    excused: bool = False
    comment: str = ""
    label: str = "By hand"


@dataclass(frozen=True)
class Delay:
    """When a submission was handed in, compared with its deadline.

    handed_in: with a time zone; None if unknown. seconds: after the deadline; 0 if on time.
    penalty: the share of the points that it costs, from 0 to 1. words: `2 days late`; empty if on time.
    """

    handed_in: datetime | None = None
    seconds: float = 0.0
    penalty: float = 0.0
    words: str = ""


@dataclass(frozen=True)
class GradedSubmission:
    """One submission and what became of it.

    source: what was handed in, as a name inside the folder of submissions; empty if nothing was.
    results: one for each exercise that was found in it; a missing one was not handed in.
    remarks: sentences about the submission as a whole, for the learner and the instructor.
    by_hand: people's decisions, in the order in which they were written down.
    lateness: None if no deadline was set.
    """

    person: Person
    source: str
    results: tuple[Result, ...] = ()
    remarks: tuple[str, ...] = ()
    by_hand: tuple[HandMark, ...] = ()
    lateness: Delay | None = None


@dataclass(frozen=True)
class Gradebook:
    """A graded class.

    graded: can be iterated more than once, and need not be in memory: its `__iter__` may read one
    submission after another from where they are stored. Only results of the listed `exercises`
    are reported. began, ended: with a time zone. containment: how submissions were isolated.
    """

    course: str
    exercises: tuple[GradedExercise, ...]
    graded: Iterable[GradedSubmission]
    began: datetime
    ended: datetime
    containment: str = ""

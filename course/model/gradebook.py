"""What a graded class is: who, which exercises, and how each of them ended."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from datetime import datetime

from course.model.result import Result


@dataclass(frozen=True)
class Person:
    """Who handed something in.

    id: unique in the class, the same each time (a roster's id, or the submission's name). name: safe to show.
    late: what the LMS says, None where it says nothing. handed_in: when, None where that is not known; it has
    no time zone where it is in that of the class.
    group: empty for who works alone. graded_as: the id of whose submission counts for this person, too.
    renamed: ids of exercises in which theirs is graded as if it were named right.
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
    """One exercise that was asked for. max_points: what it brings when all of its checks apply."""

    id: str
    title: str
    max_points: float
    bonus: bool = False


@dataclass(frozen=True)
class HandMark:
    """What a person decided about a submission, or once for the class, beside the machine's verdicts.

    exercise: its id, "" for the submission as a whole. check: the id of one of its checks, "" for all of it.
    points: what is earned there instead of the machine's points. bonus: added to them; below zero takes away.
    excused: it does not count. comment: for the learner. label: what the sentence begins with.
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
    """When a submission was handed in, held against its deadline.

    handed_in: with a time zone, None when not known. seconds: after the deadline, 0 when in time.
    penalty: the share of the points that it costs, from 0 to 1. words: `2 days late`, empty when in time.
    """

    handed_in: datetime | None = None
    seconds: float = 0.0
    penalty: float = 0.0
    words: str = ""


@dataclass(frozen=True)
class GradedSubmission:
    """One submission and what became of it.

    source: what was handed in, as a name inside the folder of submissions; empty when nothing was.
    results: one for each exercise that was found in it; a missing one was not handed in.
    remarks: sentences about the submission as a whole, for the learner and the instructor.
    by_hand: people's decisions, in the order in which they were written down.
    lateness: None where no deadline was set.
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

    graded: can be walked more than once, and need not be in memory: an object whose `__iter__` reads
    one submission after another from where they are stored. Only results of the listed `exercises`
    are reported. began, ended: with a time zone. containment: how submissions were kept apart.
    """

    course: str
    exercises: tuple[GradedExercise, ...]
    graded: Iterable[GradedSubmission]
    began: datetime
    ended: datetime
    containment: str = ""

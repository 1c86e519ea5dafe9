"""One submission as every format shows it: cleaned, each exercise with a verdict, and the totals.

Points are None where there are none to give: after an error of ours, or where an exercise does not
apply. A total is None as long as one of its parts is missing through our fault, so nobody takes it
for a mark.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import PurePosixPath

from course.grading.result import Result, Verdict
from course.report.gradebook.cleaning import NAME_LIMIT, Cleaner
from course.report.gradebook.model import Gradebook, Graded, GradedExercise, Person

NOT_HANDED_IN = "not handed in"
COMPLETE = "complete"
INCOMPLETE = "incomplete"
_OPEN = (Verdict.OUR_ERROR.value, Verdict.NOT_AVAILABLE.value)
_NO_POINTS = (*_OPEN, Verdict.NOT_APPLICABLE.value)


@dataclass(frozen=True)
class Mark:
    """How one exercise ended for one person; `result` is None when it was not handed in."""

    exercise: GradedExercise
    result: Result | None = None

    @property
    def verdict(self) -> str:
        """A `Verdict`'s value, or NOT_HANDED_IN."""
        return self.result.verdict.value if self.result else NOT_HANDED_IN

    @property
    def is_open(self) -> bool:
        """Whether there is no verdict through no fault of the learner's."""
        return self.verdict in _OPEN

    @property
    def counts(self) -> bool:
        """Whether it has points: earned ones, or none for what was not handed in."""
        return self.verdict not in _NO_POINTS

    @property
    def points(self) -> float | None:
        if not self.counts:
            return None
        return tidy(self.result.points) if self.result else 0

    @property
    def max_points(self) -> float | None:
        """What could be had without bonus checks."""
        if not self.counts:
            return None
        return tidy(self.result.max_points if self.result else self.exercise.max_points)

    @property
    def seconds(self) -> float:
        return self.result.timing.total if self.result else 0.0


@dataclass(frozen=True)
class Sheet:
    """All marks of one person, in the order of the gradebook's exercises. Every text is clean."""

    person: Person
    source: str
    remarks: tuple[str, ...]
    marks: tuple[Mark, ...]

    @property
    def state(self) -> str:
        """COMPLETE; INCOMPLETE when a verdict is missing through our fault; or NOT_HANDED_IN: nothing was."""
        if any(mark.is_open for mark in self.marks):
            return INCOMPLETE
        return COMPLETE if any(mark.result for mark in self.marks) else NOT_HANDED_IN

    @property
    def judged_points(self) -> float:
        """Points of all that was judged, bonus included."""
        return tidy(sum(mark.points or 0 for mark in self.marks))

    @property
    def judged_max(self) -> float:
        """What all that was judged could bring, without bonus exercises and bonus checks."""
        return tidy(sum(mark.max_points or 0 for mark in self.marks if not mark.exercise.bonus))

    @property
    def points(self) -> float | None:
        return None if self.state == INCOMPLETE else self.judged_points

    @property
    def max_points(self) -> float | None:
        return None if self.state == INCOMPLETE else self.judged_max

    @property
    def seconds(self) -> float:
        return sum(mark.seconds for mark in self.marks)


def sheets(gradebook: Gradebook, cleaner: Cleaner) -> Iterator[Sheet]:
    """Every submission of the gradebook, one at a time."""
    exercises = exercises_of(gradebook, cleaner)
    return (_sheet(graded, exercises, cleaner) for graded in gradebook.graded)


def exercises_of(gradebook: Gradebook, cleaner: Cleaner) -> tuple[GradedExercise, ...]:
    """The gradebook's exercises, with clean texts."""
    return tuple(
        replace(one, id=cleaner.line(one.id, NAME_LIMIT), title=cleaner.prose(one.title))
        for one in gradebook.exercises
    )


def tidy(points: float) -> float:
    """Points without what binary fractions leave behind: 0.3 for 0.1 + 0.2, 2 for 2.0."""
    rounded = round(points, 4)
    return int(rounded) if rounded == int(rounded) else rounded


def _sheet(graded: Graded, exercises: tuple[GradedExercise, ...], cleaner: Cleaner) -> Sheet:
    found = {result.exercise: result for result in map(cleaner.result, graded.results)}
    person = Person(cleaner.line(graded.person.id, NAME_LIMIT), cleaner.line(graded.person.name, NAME_LIMIT))
    return Sheet(
        person=person,
        source=cleaner.line(_inside(graded.source), NAME_LIMIT),
        remarks=cleaner.remarks(graded.remarks),
        marks=tuple(Mark(exercise, found.get(exercise.id)) for exercise in exercises),
    )


def _inside(source: str) -> str:
    """Where on the machine a submission lies is nobody's business."""
    return PurePosixPath(source).name if source.startswith("/") else source

"""One submission as every format shows it: cleaned, each exercise with a verdict, and the totals.

Points are None if there are none to give: after an error of ours, or if an exercise does not apply. A total
is None as long as one of its parts is missing through our fault, so that nobody takes it for a final mark.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import PurePosixPath

from course.model import replace
from course.model.gradebook import Delay, Gradebook, GradedExercise, GradedSubmission, HandMark, Person
from course.model.result import Result, Verdict
from course.report.gradebook.cleaning import NAME_LIMIT, Cleaner

NOT_HANDED_IN = "not handed in"
EXCUSED = "excused"
MARKED = "marked by hand"
COMPLETE = "complete"
INCOMPLETE = "incomplete"
_OPEN = (Verdict.OUR_ERROR.value, Verdict.NOT_AVAILABLE.value)
_NO_POINTS = (*_OPEN, Verdict.NOT_APPLICABLE.value, EXCUSED)


@dataclass(frozen=True)
class Mark:
    """How one exercise ended for one person; `result` is None if it was not handed in.

    by_hand: people's decisions about it. penalty: the share of its points that is lost because of lateness.
    """

    exercise: GradedExercise
    result: Result | None = None
    by_hand: tuple[HandMark, ...] = ()
    penalty: float = 0.0

    @property
    def verdict(self) -> str:
        """A `Verdict`'s value, or NOT_HANDED_IN, EXCUSED, or MARKED (only a person gave points)."""
        if any(each.excused for each in self.by_hand):
            return EXCUSED
        verdict = self.result.verdict.value if self.result else NOT_HANDED_IN
        return MARKED if verdict in _NO_POINTS and self._set_points is not None else verdict

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
        """The final points."""
        return None if self.raw_points is None else tidy(self.raw_points * (1 - self.penalty))

    @property
    def raw_points(self) -> float | None:
        """Points including what people decided, but before the penalty for lateness; never below zero."""
        if not self.counts:
            return None
        earned = self._earned if self._set_points is None else self._set_points
        return tidy(max(0, earned + sum(each.bonus for each in self.by_hand)))

    @property
    def max_points(self) -> float | None:
        """The maximum, without bonus checks."""
        if not self.counts:
            return None
        judged = self.result and self.verdict != MARKED
        return tidy(self.result.max_points if self.result and judged else self.exercise.max_points)

    @property
    def seconds(self) -> float:
        return self.result.timing.total if self.result else 0.0

    @property
    def _set_points(self) -> float | None:
        """Points that a person gave for the whole exercise. The last entry counts."""
        given = [each.points for each in self.by_hand if not each.check and each.points is not None]
        return given[-1] if given else None

    @property
    def _earned(self) -> float:
        by_check = {check.id: check.earned for check in (self.result.checks if self.result else ())}
        by_check.update({each.check: each.points for each in self.by_hand if each.points is not None})
        return sum(by_check.values())


@dataclass(frozen=True)
class Sheet:
    """All marks of one person, in the order of the gradebook's exercises. Every text is clean.

    by_hand: people's decisions about the submission as a whole. lateness: None if there is no deadline.
    """

    person: Person
    source: str
    remarks: tuple[str, ...]
    marks: tuple[Mark, ...]
    by_hand: tuple[HandMark, ...] = ()
    lateness: Delay | None = None

    @property
    def state(self) -> str:
        """INCOMPLETE: a verdict is missing through no fault of the learner's. EXCUSED: from everything.

        NOT_HANDED_IN: nothing was. COMPLETE: otherwise.
        """
        if any(mark.is_open for mark in self.marks):
            return INCOMPLETE
        verdicts = {mark.verdict for mark in self.marks}
        if verdicts == {EXCUSED}:
            return EXCUSED
        return NOT_HANDED_IN if verdicts <= {EXCUSED, NOT_HANDED_IN} and not self._bonus else COMPLETE

    @property
    def judged_points(self) -> float:
        """Points of everything that was judged, including bonuses, after the penalty for lateness."""
        return tidy(max(0, sum(mark.points or 0 for mark in self.marks) + self._bonus))

    @property
    def raw_points(self) -> float:
        """Like `judged_points`, but without the penalty for lateness."""
        return tidy(max(0, sum(mark.raw_points or 0 for mark in self.marks) + self._bonus))

    @property
    def judged_max(self) -> float:
        """The maximum of everything that was judged, without bonus exercises and bonus checks."""
        return tidy(sum(mark.max_points or 0 for mark in self.marks if not mark.exercise.bonus))

    @property
    def points(self) -> float | None:
        return None if self.state in (INCOMPLETE, EXCUSED) else self.judged_points

    @property
    def max_points(self) -> float | None:
        return None if self.state in (INCOMPLETE, EXCUSED) else self.judged_max

    @property
    def late(self) -> str:
        """`2 days late`; empty if it was on time or there is no deadline."""
        return self.lateness.words if self.lateness else ""

    @property
    def seconds(self) -> float:
        return sum(mark.seconds for mark in self.marks)

    @property
    def _bonus(self) -> float:
        return sum(each.bonus for each in self.by_hand)


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
    """Points without the errors of binary fractions: 0.3 for 0.1 + 0.2, 2 for 2.0."""
    rounded = round(points, 4)
    return int(rounded) if rounded == int(rounded) else rounded


def _sheet(graded: GradedSubmission, exercises: tuple[GradedExercise, ...], cleaner: Cleaner) -> Sheet:
    found = {result.exercise: result for result in map(cleaner.result, graded.results)}
    person = Person(cleaner.line(graded.person.id, NAME_LIMIT), cleaner.line(graded.person.name, NAME_LIMIT))
    by_hand = tuple(replace(each, comment=cleaner.prose(each.comment)) for each in graded.by_hand)
    penalty = graded.lateness.penalty if graded.lateness else 0.0
    return Sheet(
        person=person,
        source=cleaner.line(_inside(graded.source), NAME_LIMIT),
        remarks=cleaner.remarks(graded.remarks),
        marks=tuple(
            Mark(exercise, found.get(exercise.id), _about(exercise, by_hand), penalty)
            for exercise in exercises
        ),
        by_hand=tuple(each for each in by_hand if not each.exercise),
        lateness=graded.lateness,
    )


def _about(exercise: GradedExercise, by_hand: tuple[HandMark, ...]) -> tuple[HandMark, ...]:
    """The decisions about this exercise. Someone who is excused from everything is excused from it, too."""
    whole = (HandMark(excused=True),) if any(each.excused and not each.exercise for each in by_hand) else ()
    return (*whole, *(each for each in by_hand if each.exercise == exercise.id))


def _inside(source: str) -> str:
    """`source` without the submission's place on this machine, which readers must not learn."""
    return PurePosixPath(source).name if source.startswith("/") else source


class Names:
    """Makes names unique: the second `ada` is `ada (2)`."""

    def __init__(self) -> None:
        self._taken: set[str] = set()

    def unique(self, name: str) -> str:
        found, count = name, 1
        while found in self._taken:
            count += 1
            found = f"{name} ({count})"
        self._taken.add(found)
        return found


_PLAIN_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,79}")
_MADE_NAME = re.compile(r".*-[0-9a-f]{12}")


def file_stem(person_id: str) -> str:
    """A file name for a person: the id itself if that is harmless, else its harmless part and a hash.

    Different ids get different names.
    """
    if _PLAIN_NAME.fullmatch(person_id) and not _MADE_NAME.fullmatch(person_id):
        return person_id
    harmless = re.sub(r"[^A-Za-z0-9]+", "-", person_id).strip("-")[:40] or "person"
    return f"{harmless}-{hashlib.sha256(person_id.encode('utf-8', 'surrogatepass')).hexdigest()[:12]}"

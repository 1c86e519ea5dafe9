"""What the page is made of."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from datetime import datetime

from course.report.gradebook.model import GradedExercise
from course.report.gradebook.sheets import Mark, Sheet

# A person's place in the class, from 0, and an exercise's id.
Key = tuple[int, str]


@dataclass(frozen=True)
class ClassPage:
    """A graded class. Every text is clean (see `course.report.gradebook.cleaning`).

    sheets: in the order of the class. pictures: `<svg>` elements of some gradings. not_drawn: how many
    recordings have none, since the page would become too large. ended: when this was read.
    """

    course: str
    exercises: tuple[GradedExercise, ...]
    sheets: tuple[Sheet, ...]
    began: datetime
    ended: datetime
    pictures: Mapping[Key, tuple[str, ...]] = field(default_factory=dict)
    not_drawn: int = 0

    def marks(self, exercise: GradedExercise) -> Iterator[tuple[int, Mark]]:
        """Of everybody, with their place in the class."""
        at = self.exercises.index(exercise)
        return ((place, sheet.marks[at]) for place, sheet in enumerate(self.sheets))

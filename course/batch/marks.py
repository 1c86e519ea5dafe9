"""marks.yaml in a results' folder: what people decided, on top of what the machine found."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

from pydantic import BeforeValidator, Field

from course.batch.deadlines import (
    ClassList,
    Deadlines,
    Written,
    read_deadlines,
    read_written,
    seconds_of,
    usage,
)
from course.content.document import Document, Place
from course.errors import ContentError
from course.model.gradebook import Delay, HandMark, Person
from course.spelling import did_you_mean

FILE = "marks.yaml"
Marks = Mapping[str, tuple[HandMark, ...]]


def _listed(value: object) -> object:
    return value if isinstance(value, list) else [value]


def _late(value: object) -> object:
    return 0.0 if str(value).strip().lower() in ("no", "false") else seconds_of(value)


class RubricItem(Written):
    bonus: float = Field(0, description="added to the points; below zero is subtracted")
    comment: str = Field("", description="for the learner")


class MarkEntry(Written):
    person: Annotated[list[str], BeforeValidator(_listed)] = Field(
        description="an id or a name from results.csv, or a list of these"
    )
    exercise: str = Field("", description="its id; without one, the submission as a whole")
    check: str = Field("", description="the id of one of its checks")
    points: float | None = Field(
        None, ge=0, description="what is earned there, instead of the machine's points"
    )
    bonus: float = Field(0, description="added to the points; below zero is subtracted")
    comment: str = Field("", description="for the learner")
    rubric: Annotated[list[str], BeforeValidator(_listed)] = Field([], description="ids of rubric items")
    excused: bool = Field(False, description="true: it does not count")
    late: Annotated[float | None, BeforeValidator(_late)] = Field(
        None, description="`no`, or by how much, such as 2 days"
    )


class MarksFile(Written):
    rubric: dict[str, RubricItem] = Field({}, description="items by id, to be used by several marks")
    marks: list[MarkEntry] = Field([], description="a list of decisions")


@dataclass(frozen=True)
class Decisions:
    """All that people decided for a class. late_by: by person, the seconds that somebody wrote."""

    marks: Marks = field(default_factory=dict)
    late_by: Mapping[str, float] = field(default_factory=dict)
    deadlines: Deadlines | None = None

    def lateness(self, person: Person, *, handed_in: bool) -> Delay | None:
        if self.deadlines is None:
            return None
        late_by = self.late_by.get(person.id)
        return self.deadlines.lateness(person, handed_in=handed_in, late_by=late_by)


NONE = Decisions()


def read_decisions(folder: Path, people: Iterable[Person], checks: Mapping[str, Iterable[str]]) -> Decisions:
    """What marks.yaml and deadlines.yaml say, checked against the class, so that no typo goes unnoticed.

    checks: ids of checks and questions, by exercise. Raises UsageError, which names the lines.
    """
    known = ClassList(people)
    deadlines = read_deadlines(folder, known)
    if not (folder / FILE).is_file():
        return Decisions(deadlines=deadlines)
    found, document = read_written(folder / FILE, MarksFile)
    reading = _Reading(found, document, known, {one: tuple(ids) for one, ids in checks.items()}, deadlines)
    errors = list(reading.errors())
    if errors:
        raise usage(errors)
    return reading.decisions()


class _Reading:
    def __init__(
        self,
        found: MarksFile,
        document: Document,
        people: ClassList,
        checks: Mapping[str, tuple[str, ...]],
        deadlines: Deadlines | None,
    ) -> None:
        self._found = found
        self._document = document
        self._people = people
        self._checks = checks
        self._deadlines = deadlines

    def errors(self) -> Iterator[ContentError]:
        for number, entry in enumerate(self._found.marks):
            place: Place = ("marks", number)
            whose = (self._people.find(who, self._document, (*place, "person")) for who in entry.person)
            yield from (who for who in whose if isinstance(who, ContentError))
            yield from self._misnamed(entry, place)
            yield from self._senseless(entry, place)

    def _misnamed(self, entry: MarkEntry, place: Place) -> Iterator[ContentError]:
        if entry.exercise and entry.exercise not in self._checks:
            yield self._unknown("exercise", entry.exercise, self._checks, place)
        elif entry.check and entry.check not in self._checks.get(entry.exercise, ()):
            yield self._unknown("check", entry.check, self._checks.get(entry.exercise, ()), place)
        for item in entry.rubric:
            if item not in self._found.rubric:
                yield self._unknown("rubric", item, self._found.rubric, place)

    def _senseless(self, entry: MarkEntry, place: Place) -> Iterator[ContentError]:
        if entry.points is not None and not entry.exercise:
            what = "`points` replaces the points of an exercise, and none is named"
            yield self._document.error(what, "add `exercise`, or use `bonus`", place=(*place, "points"))
        if entry.check and entry.excused:
            what = "one check cannot be excused"
            yield self._document.error(what, "give its points instead", place=(*place, "excused"))
        if entry.late and self._deadlines is None:
            what = "nothing says what being late costs"
            yield self._document.error(what, "write deadlines.yaml", place=(*place, "late"))
        if entry.late is not None and entry.exercise:
            what = "a submission is late as a whole"
            yield self._document.error(what, "leave `exercise` out", place=(*place, "late"))

    def _unknown(self, key: str, name: str, known: Iterable[str], place: Place) -> ContentError:
        every = sorted(known)
        what = f"there is no {'rubric item' if key == 'rubric' else key} `{name}`{did_you_mean(name, every)}"
        return self._document.error(what, f"there are: {', '.join(every) or 'none'}", place=(*place, key))

    def decisions(self) -> Decisions:
        """What was decided; only to be called if there are no errors."""
        marks: dict[str, tuple[HandMark, ...]] = {}
        late_by: dict[str, float] = {}
        for name, entry in ((name, one) for one in self._found.marks for name in one.person):
            who = str(self._people.find(name, self._document, ()))
            marks[who] = (*marks.get(who, ()), *self._of(entry))
            if entry.late is not None:
                late_by[who] = entry.late
        return Decisions(marks, late_by, self._deadlines)

    def _of(self, entry: MarkEntry) -> Iterator[HandMark]:
        place = (entry.exercise, entry.check)
        if entry.points is not None or entry.bonus or entry.excused or entry.comment:
            yield HandMark(*place, entry.points, entry.bonus, entry.excused, entry.comment)
        for item in (self._found.rubric[name] for name in entry.rubric):
            yield HandMark(*place, bonus=item.bonus, comment=item.comment)

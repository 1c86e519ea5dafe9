"""deadlines.yaml in a results' folder: when work was due, and what being late costs."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from datetime import datetime, timezone, tzinfo
from pathlib import Path
from typing import Annotated, Any
from zoneinfo import ZoneInfo

import yaml
from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, model_validator

from course.batch.intake.people import iso_moment
from course.content.document import NOT_YAML, Document, Place, read_document
from course.content.schema_errors import S, validated
from course.content.schema_types import wrong
from course.errors import ContentError, UsageError
from course.model import replace
from course.model.gradebook import Delay, Person
from course.spelling import did_you_mean

FILE = "deadlines.yaml"
_DAY = 86400.0
_UNITS = {"min": 60.0, "minute": 60.0, "h": 3600.0, "hour": 3600.0, "d": _DAY, "day": _DAY, "week": 7 * _DAY}
_DURATION = re.compile(r"(?P<count>\d+(?:\.\d+)?)\s*(?P<unit>[a-z]+?)s?")
NOT_KNOWN = "time not known"
# What to say about people whose time is not known, by whether the LMS calls them late (None: unknown).
_WITHOUT_A_TIME = {None: NOT_KNOWN, True: f"late, {NOT_KNOWN}", False: ""}


def seconds_of(value: object) -> object:
    """`2 days`, `36 h`, `15 min` as seconds."""
    found = _DURATION.fullmatch(str(value).strip().lower())
    if found is None or found["unit"] not in _UNITS:
        raise wrong(f"must be a time span such as `2 days`, `36 h` or `15 min`, not `{value}`")
    return float(found["count"]) * _UNITS[found["unit"]]


def _moment(value: object) -> object:
    """A date with a time; one without a zone gets the file's zone later."""
    text = str(value).strip()
    if re.fullmatch(r"\d{4}-\d\d-\d\d", text):
        raise wrong(f"must have a time of day, such as `{value} 23:59`")
    try:
        return iso_moment(text)
    except ValueError:
        raise wrong(f"must be a date and a time such as `2026-10-05 23:59`, not `{value}`") from None


def _zone(value: object) -> object:
    try:
        return ZoneInfo(str(value))
    except (OSError, ValueError, KeyError):  # ZoneInfoNotFoundError is a KeyError
        raise wrong(f"must be a time zone such as `America/New_York`, not `{value}`") from None


Span = Annotated[float, BeforeValidator(seconds_of)]
Moment = Annotated[datetime, BeforeValidator(_moment)]
Zone = Annotated[ZoneInfo, BeforeValidator(_zone)]


class Written(BaseModel):
    """A mapping in a file that people write: unknown keys are errors, keys without a value are left out."""

    model_config = ConfigDict(extra="forbid", arbitrary_types_allowed=True, allow_inf_nan=False)

    @model_validator(mode="before")
    @classmethod
    def _filled(cls, data: Any) -> Any:
        return {key: value for key, value in data.items() if value != ""} if isinstance(data, dict) else data


class Penalty(Written):
    percent: float = Field(gt=0, le=100, description="of the points earned, for each step")
    each: Span = Field(_DAY, gt=0, description="the step, by default a day; one that has begun counts")
    most: float = Field(100, gt=0, le=100, description="percent; being late never costs more")


class Deadlines(Written):
    """What the file contains. Times without an offset are in `zone`."""

    due: Moment = Field(description="a date and a time, such as 2026-10-05 23:59")
    zone: Zone | None = Field(None, description="such as America/New_York; by default, this machine's")
    grace: Span = Field(0.0, description="late by no more than this counts as on time, such as 15 min")
    late_days: int = Field(0, ge=0, description="days that everyone may be late without a penalty")
    late_days_used: dict[str, int] = Field({}, description="by person: days already spent on earlier work")
    penalty: Penalty | None = Field(None, description="percent, each, most")
    closes: Span | None = Field(None, description="handed in later than this after the deadline: no points")
    extensions: dict[str, Moment] = Field({}, description="by person: when it is due for them")
    handed_in: dict[str, Moment] = Field({}, description="by person: when they did, if nothing else says so")

    def _aware(self, moment: datetime) -> datetime:
        if moment.tzinfo is None:
            zone: tzinfo | None = self.zone
            moment = moment.replace(tzinfo=zone) if zone else moment.astimezone()
        return moment.astimezone(timezone.utc)

    def lateness(self, person: Person, *, handed_in: bool, late_by: float | None = None) -> Delay:
        """How late a person is. handed_in: whether anything was. late_by: seconds; None to find out."""
        if not handed_in:
            return Delay()
        told = self.handed_in.get(person.id, person.handed_in)
        if late_by is None and told is None:
            return Delay(words=_WITHOUT_A_TIME[person.late])
        at = self._aware(told) if told else None
        due = self._aware(self.extensions.get(person.id, self.due))
        seconds = (at - due).total_seconds() if at and late_by is None else late_by or 0.0
        return replace(self._held_against(person, seconds), handed_in=at)

    def _held_against(self, person: Person, seconds: float) -> Delay:
        if seconds <= self.grace:
            return Delay()
        days = max(0, self.late_days - self.late_days_used.get(person.id, 0))
        used = min(days, math.ceil(seconds / _DAY))
        words = f"{duration(seconds)} late"
        if used:
            words += f" ({used} late {'day' if used == 1 else 'days'} used)"
        return Delay(None, seconds, self._cost(seconds, seconds - used * _DAY), words)

    def _cost(self, seconds: float, left: float) -> float:
        """The fraction of the points that it costs. left: seconds that no free day covers."""
        if self.closes is not None and seconds > self.closes:
            return 1.0
        if self.penalty is None or left <= 0:
            return 0.0
        percent = math.ceil(left / self.penalty.each) * self.penalty.percent
        return min(percent, self.penalty.most) / 100


def duration(seconds: float) -> str:
    """`2 days 3 hours`, `25 minutes`; minutes are rounded up."""
    minutes = math.ceil(seconds / 60)
    days, rest = divmod(minutes, 24 * 60)
    hours, minutes = divmod(rest, 60)
    counts = ((days, "day"), (hours, "hour"), (minutes, "minute"))
    return " ".join(f"{count} {unit}{'s' * (count != 1)}" for count, unit in counts if count)


def read_written(file: Path, schema: type[S]) -> tuple[S, Document]:
    """A YAML file that people write, every value taken as it is written (`007` stays `007`).

    Raises UsageError, which names the lines.
    """
    try:
        document = read_document(file)
        texts = yaml.BaseLoader("").construct_document(document.root) if document.root else None
    except ContentError as error:
        raise usage([error]) from None
    except NOT_YAML as error:
        raise usage([ContentError(f"this is not YAML: {error}".replace("\n", " "), file=file)]) from None
    document = replace(document, data=texts or {})
    found, errors = validated(document, schema)
    if errors or found is None:
        raise usage(errors)
    return found, document


def usage(errors: Iterable[ContentError]) -> UsageError:
    every = list(errors)
    return UsageError("\n".join(map(str, every)), every[0].next_step)


class ClassList:
    """The people of a class, to find those that a file names."""

    def __init__(self, people: Iterable[Person]) -> None:
        self._ids: dict[str, str] = {}
        names: dict[str, list[str]] = {}
        for one in people:
            self._ids[one.id] = one.id
            names.setdefault(one.name, []).append(one.id)
        self._names: Mapping[str, str] = {name: ids[0] for name, ids in names.items() if len(ids) == 1}

    def find(self, who: str, document: Document, place: Place) -> str | ContentError:
        """The id of a person who is named by id, or by a name that only one person has."""
        found = self._ids.get(who, self._names.get(who))
        if found is not None:
            return found
        known = {**self._names, **self._ids}
        what = f"nobody in this class is called `{who}`{did_you_mean(who, known)}"
        return document.error(what, "use an id from the first column of results.csv", place=place)

    def keyed(self, by_person: dict[str, Any], document: Document, key: str) -> dict[str, Any]:
        """The same mapping with ids as keys. Raises UsageError for people who are not in the class."""
        found = {who: self.find(who, document, (key, who)) for who in by_person}
        errors = [each for each in found.values() if isinstance(each, ContentError)]
        if errors:
            raise usage(errors)
        return {str(found[who]): value for who, value in by_person.items()}


def read_deadlines(folder: Path, people: ClassList) -> Deadlines | None:
    """Read the folder's file; None if there is none. Raises UsageError if anything is wrong with it."""
    if not (folder / FILE).is_file():
        return None
    found, document = read_written(folder / FILE, Deadlines)
    named = ("extensions", "handed_in", "late_days_used")
    return found.model_copy(update={key: people.keyed(getattr(found, key), document, key) for key in named})

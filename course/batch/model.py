"""What is graded in a batch, and what comes of it: plain data, which may travel to another process."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from typing import Any

from course.grading.result import Result, from_json, to_json


@dataclass(frozen=True)
class Unit:
    """One exercise of one submission. attempt: from 1."""

    person: str
    exercise: str
    attempt: int = 1

    def again(self) -> Unit:
        return Unit(self.person, self.exercise, self.attempt + 1)


@dataclass(frozen=True)
class Task:
    """A unit, ready to be graded. home: the laid-out course home. evidence: where to keep the recording.

    course: root of the course, None for the one that comes along. contained: refuse to run it otherwise.
    """

    unit: Unit
    home: str
    evidence: str
    course: str | None = None
    contained: bool = True


@dataclass(frozen=True)
class Graded:
    """What became of a unit. seconds: from taking it up to its end."""

    unit: Unit
    result: Result
    seconds: float


def task_to_line(task: Task) -> str:
    return json.dumps(asdict(task))


def task_from_line(line: str) -> Task:
    data: dict[str, Any] = json.loads(line)
    return Task(**{**data, "unit": Unit(**data["unit"])})


def graded_to_line(graded: Graded) -> str:
    return json.dumps(
        {"unit": asdict(graded.unit), "result": to_json(graded.result), "seconds": graded.seconds}
    )


def graded_from_line(line: str) -> Graded:
    """Raises ValueError, KeyError or TypeError when a worker did not write it."""
    data = json.loads(line)
    return Graded(Unit(**data["unit"]), from_json(data["result"]), data["seconds"])

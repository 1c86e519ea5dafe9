"""A stored recording, what becomes of it when it is judged again, and both as lines of JSON."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from enum import Enum
from pathlib import Path
from typing import Any, Generic, TypeVar

from course.content import Exercise
from course.grading.channel import Judgement, read_message

Key = TypeVar("Key")

# Seconds for one recording; nearly all take milliseconds.
MOST_TIME = 60
# So many share one collection by pytest (some 50 ms), and at most so many reports that it keeps.
PORTION = 50
# The first line of a worker, before its answers.
READY = "ready"


@dataclass(frozen=True)
class Stored(Generic[Key]):
    """A recording (MCAP) of an exercise. key: by which the caller knows it; it stays with the caller."""

    key: Key
    exercise: Exercise
    file: Path


class Trouble(str, Enum):
    """Why a recording cannot be judged.

    FORMAT: it is whole, but of another version of the course. EXERCISE: of another one than was said.
    FATAL: the process that judged it died of it, or did not come to an end.
    """

    MISSING = "missing"
    DAMAGED = "damaged"
    FORMAT = "of another format"
    EXERCISE = "of another exercise"
    FATAL = "cannot be judged"


@dataclass(frozen=True)
class Problem:
    """A recording that was not judged. what: one line for the instructor, without its path."""

    trouble: Trouble
    what: str


class Scenario(str, Enum):
    """Whether today's scenario would record the same (see `scenario_digest`).

    UNKNOWN: the recording does not say what made it.
    """

    SAME = "same"
    CHANGED = "changed"
    UNKNOWN = "unknown"


@dataclass(frozen=True)
class Rejudged:
    """What the checks of now say of a recording."""

    judgement: Judgement
    scenario: Scenario


@dataclass(frozen=True)
class Portion:
    """Recordings whose checks are in one module. looks_at: by exercise. files: (exercise, path)."""

    grader: str
    looks_at: Mapping[str, Sequence[str]]
    files: Sequence[tuple[str, str]]


def portion_to_line(portion: Portion) -> str:
    return json.dumps(asdict(portion))


def portion_from_line(line: str) -> Portion:
    return Portion(**json.loads(line))


def answer_to_line(answer: Rejudged | Problem) -> str:
    if isinstance(answer, Problem):
        return json.dumps({"kind": "problem", **asdict(answer)})
    data = {"kind": "judgement", **asdict(answer.judgement), "scenario": answer.scenario}
    return json.dumps(data)


def answer_from_line(line: str) -> Rejudged | Problem:
    """Read what `answer_to_line` wrote. Raises ValueError or KeyError on anything else."""
    data: dict[str, Any] = json.loads(line)
    if data["kind"] == "problem":
        return Problem(Trouble(data["trouble"]), data["what"])
    judgement = read_message(line)
    if not isinstance(judgement, Judgement):
        raise ValueError("this is no judgement")
    return Rejudged(judgement, Scenario(data["scenario"]))

"""What is said to a learner whose work did not pass: data, never text glued together.

Rooms below `grading` (build, evidence) make feedback too, so it lives at the bottom.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Location:
    """A place in the learner's files. `file` is relative to the course home; `line` counts from 1."""

    file: str
    line: int | None = None

    def __str__(self) -> str:
        return f"{self.file}:{self.line}" if self.line else self.file


@dataclass(frozen=True)
class Feedback:
    """Why a check did not pass, as data.

    summary: one sentence that names the cause.
    expected, seen: short phrases, where a comparison helps.
    where: places in the learner's files, most telling first.
    advice: what to do next, one or two sentences; may hold `code` in backquotes.
    details: lines of evidence (a shortened log, traceback or list), shown as they are.
    """

    summary: str
    expected: str | None = None
    seen: str | None = None
    where: tuple[Location, ...] = ()
    advice: str | None = None
    details: tuple[str, ...] = ()


@dataclass(frozen=True)
class Pace:
    """What a check asked of how often messages come: the median seconds between two on `topic`."""

    topic: str
    shortest: float
    longest: float


def feedback_from_dict(data: Mapping[str, Any] | None) -> Feedback | None:
    """Feedback out of its JSON form."""
    if data is None:
        return None
    places = tuple(Location(**place) for place in data["where"])
    return Feedback(**{**data, "where": places, "details": tuple(data["details"])})


class NotApplicable(Exception):
    """A check that cannot be judged here, through nobody's fault: it takes no part in the verdict.

    because: one sentence for the learner, e.g. what this machine lacks.
    """

    def __init__(self, because: str) -> None:
        super().__init__(because)
        self.because = because


class Spoilt(Exception):
    """The recording shows a fault of somebody else's, not of the learner's: it has to be made again."""


class Failure(Exception):
    """The learner's work does not do what was asked; carries the feedback that says so.

    Only a `Failure` blames the learner. Any other exception in a check is our error.
    """

    def __init__(self, feedback: Feedback) -> None:
        super().__init__(feedback.summary)
        self.feedback = feedback

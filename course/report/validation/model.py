"""What is shown of a course that is proven: plain data; texts are cleaned when they are shown."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Note:
    """Something that was found. file: as it is shown, relative where that is shorter. line: from 1."""

    file: str
    line: int | None
    what: str
    next_step: str | None
    exercise: str | None = None


@dataclass(frozen=True)
class Count:
    """Of the proofs of one kind: how many held, how many are done, how many there are."""

    held: int = 0
    done: int = 0
    total: int = 0


@dataclass(frozen=True)
class Row:
    """One exercise. covered: how many of its checks a known mistake failed. missing: what is missing here."""

    exercise: str
    solution: Count
    alternatives: Count
    starter: Count
    mistakes: Count
    covered: int
    checks: int
    points: float | None
    seconds: float
    missing: str | None = None

    @property
    def counts(self) -> tuple[Count, ...]:
        return (self.solution, self.alternatives, self.starter, self.mistakes)


@dataclass(frozen=True)
class Case:
    """One proof as a test case. notes: what was found; skipped: why it was not judged, else None."""

    exercise: str
    name: str
    seconds: float
    notes: Sequence[Note] = ()
    skipped: str | None = None

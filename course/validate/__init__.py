"""Proves a course: checks its files, and grades its own solutions, starters and mistakes."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Finding:
    """Something wrong with the course. file: absolute. line: from 1, if known.

    what: one sentence. exercise: the id of the exercise that it is about, if any.
    """

    file: Path
    line: int | None
    what: str
    next_step: str | None
    exercise: str | None = None

"""Proves a course: what is written about it, and what grading it really does."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Finding:
    """Something wrong with the course. file: absolute. line: from 1, where known.

    what: one sentence. exercise: its id, where it is about one.
    """

    file: Path
    line: int | None
    what: str
    next_step: str | None
    exercise: str | None = None

"""What a class was graded with: kept among its results, for all that comes later."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

from course.batch.results import Results
from course.errors import UsageError

_KEY = "asked"


@dataclass(frozen=True)
class Noted:
    """wanted: exercises as they were asked for. exercises: ids of what that came to. began: with a zone."""

    submissions: Path
    wanted: tuple[str, ...]
    exercises: tuple[str, ...]
    single: bool
    contained: bool
    began: datetime


def note(results: Results, noted: Noted) -> None:
    data = {**asdict(noted), "submissions": str(noted.submissions), "began": noted.began.isoformat()}
    results.note(_KEY, json.dumps(data))


def noted(results: Results) -> Noted:
    """Raises UsageError when `grade` had not got as far as that."""
    text = results.noted(_KEY)
    if text is None:
        raise UsageError("Nothing has been graded there yet.", "Grade the class first.")
    data: dict[str, Any] = json.loads(text)
    return Noted(
        Path(data["submissions"]),
        tuple(data["wanted"]),
        tuple(data["exercises"]),
        data["single"],
        data["contained"],
        datetime.fromisoformat(data["began"]),
    )

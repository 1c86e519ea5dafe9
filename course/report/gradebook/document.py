"""results.json: everything that may be told, for programs.

Its schema is `results.schema.json`, beside this file.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from dataclasses import asdict
from importlib.resources import files
from typing import Any

from course.grading.result import CheckResult
from course.report.gradebook.cleaning import NAME_LIMIT, Cleaner
from course.report.gradebook.model import Gradebook
from course.report.gradebook.sheets import Mark, Sheet, exercises_of, tidy

VERSION = 1


def schema() -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of this version."""
    text = files("course.report.gradebook").joinpath("results.schema.json").read_text(encoding="utf-8")
    read: dict[str, Any] = json.loads(text)
    return read


def pieces(gradebook: Gradebook, cleaner: Cleaner, sheets: Iterable[Sheet]) -> Iterator[str]:
    """The document, a submission at a time."""
    head = {
        "schema": VERSION,
        "course": cleaner.prose(gradebook.course),
        "began": gradebook.began.isoformat(timespec="seconds"),
        "ended": gradebook.ended.isoformat(timespec="seconds"),
        "containment": cleaner.line(gradebook.containment, NAME_LIMIT),
        "exercises": [asdict(exercise) for exercise in exercises_of(gradebook, cleaner)],
    }
    yield f'{_json(head, indent=2).removesuffix("}").rstrip()},\n  "graded": ['
    separator = "\n"
    for sheet in sheets:
        yield f"{separator}    {_json(as_data(sheet))}"
        separator = ",\n"
    yield "\n  ]\n}\n"


def as_data(sheet: Sheet) -> dict[str, Any]:
    """One submission as JSON types."""
    return {
        "id": sheet.person.id,
        "name": sheet.person.name,
        "source": sheet.source,
        "state": sheet.state,
        "points": sheet.points,
        "max_points": sheet.max_points,
        "remarks": list(sheet.remarks),
        "results": [_mark(mark) for mark in sheet.marks],
    }


def _mark(mark: Mark) -> dict[str, Any]:
    return {
        "exercise": mark.exercise.id,
        "verdict": mark.verdict,
        "points": mark.points,
        "max_points": mark.max_points,
        "seconds": round(mark.seconds, 3),
        "checks": [_check(check) for check in mark.result.checks] if mark.result else [],
        "notes": list(mark.result.notes) if mark.result else [],
    }


def _check(check: CheckResult) -> dict[str, Any]:
    return {
        "id": check.id,
        "title": check.title,
        "outcome": check.outcome.value,
        "points": tidy(check.earned),
        "max_points": tidy(check.points),
        "bonus": check.bonus,
        "skipped_because": check.skipped_because,
        "feedback": asdict(check.feedback) if check.feedback else None,
    }


def _json(data: object, indent: int | None = None) -> str:
    """JSON that may stand inside a web page's script too: no `<`."""
    return json.dumps(data, ensure_ascii=False, allow_nan=False, indent=indent).replace("<", "\\u003c")

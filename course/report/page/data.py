"""The page's data as JSON types: the table of the class, and each submission with its feedback."""

from __future__ import annotations

import base64
import json
import zlib
from typing import Any

from course.grading.result import CheckResult, Feedback
from course.report.gradebook.letter import NOTHING_AT_ALL, OWED
from course.report.gradebook.sheets import INCOMPLETE, NOT_HANDED_IN, Mark, Sheet
from course.report.gradebook.words import NOTHING, headline, labelled, mark_of, points_of, summary, total, why
from course.report.page.model import ClassPage

_ESCAPED = {ord(char): f"\\u{ord(char):04x}" for char in "<>&\u2028\u2029"}


def class_data(page: ClassPage) -> dict[str, Any]:
    """What the table shows; a mark is [verdict, points, max_points, seconds]."""
    return {
        "exercises": [
            {"id": one.id, "title": one.title, "max": one.max_points, "bonus": one.bonus}
            for one in page.exercises
        ],
        "people": [_person(sheet) for sheet in page.sheets],
    }


def submission_data(page: ClassPage, place: int) -> dict[str, Any]:
    """All that is told to the person at that place, and the pictures."""
    sheet = page.sheets[place]
    return {
        "id": sheet.person.id,
        "name": sheet.person.name or sheet.person.id,
        "source": sheet.source,
        "summary": summary(sheet),
        "says": [*_opening(sheet), *(f"Note: {remark}" for remark in sheet.remarks)],
        "marks": [
            {**_mark(mark), "pictures": list(page.pictures.get((place, mark.exercise.id), ()))}
            for mark in sheet.marks
        ],
    }


def as_json(data: object) -> str:
    """JSON that may stand inside a script element: nothing in it can end that, or begin a comment."""
    text = json.dumps(data, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    return text.translate(_ESCAPED)


def packed(data: object) -> str:
    """JSON, deflated, in base64: the browser opens it when it is looked at."""
    shrink = zlib.compressobj(9, zlib.DEFLATED, -15)
    text = json.dumps(data, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()
    return base64.b64encode(shrink.compress(text) + shrink.flush()).decode("ascii")


def _person(sheet: Sheet) -> dict[str, Any]:
    return {
        "id": sheet.person.id,
        "name": sheet.person.name or sheet.person.id,
        "state": sheet.state,
        "points": sheet.points,
        "max": sheet.max_points,
        "seconds": round(sheet.seconds, 1),
        "marks": [
            [mark.verdict, mark.points, mark.max_points, round(mark.seconds, 1)] for mark in sheet.marks
        ],
    }


def _opening(sheet: Sheet) -> list[str]:
    if sheet.state == NOT_HANDED_IN:
        return [NOTHING_AT_ALL]
    return [OWED] if sheet.state == INCOMPLETE else []


def _mark(mark: Mark) -> dict[str, Any]:
    result = mark.result
    return {
        "id": mark.exercise.id,
        "title": mark.exercise.title,
        "bonus": mark.exercise.bonus,
        "verdict": mark.verdict,
        "headline": headline(mark),
        "total": total(mark),
        "seconds": round(mark.seconds, 1),
        "fault": _feedback(result.fault) if result and result.fault else None,
        "notes": list(result.notes) if result else [NOTHING],
        "checks": [_check(check) for check in result.checks] if result else [],
    }


def _check(check: CheckResult) -> dict[str, Any]:
    cause = why(check)
    return {
        "mark": mark_of(check),
        "outcome": check.outcome.value,
        "title": check.title,
        "points": points_of(check),
        "why": _feedback(cause) if cause else None,
    }


def _feedback(feedback: Feedback) -> dict[str, Any]:
    parts = [[label, text] for label, text in labelled(feedback)]
    return {"summary": feedback.summary, "parts": parts, "details": list(feedback.details)}

"""The data of the page; as JSON types, its table and each submission with its feedback."""

from __future__ import annotations

import base64
import json
import zlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from datetime import datetime
from typing import Any

from course.model import replace
from course.model.gradebook import GradedExercise
from course.model.result import CheckResult, Feedback
from course.report.gradebook.check_words import (
    NOTHING,
    comments,
    decisions,
    headline,
    labeled,
    mark_of,
    says,
    summary,
    total,
    why,
)
from course.report.gradebook.sheets import Mark, Sheet
from course.report.verdict import earned_of

# A person's place in the class (from 0) and an exercise's id.
Key = tuple[int, str]
# Lines by path in the course home.
Code = Mapping[str, tuple[str, ...]]


@dataclass(frozen=True)
class ClassPage:
    """A graded class. Every text is clean (see `course.report.gradebook.cleaning`).

    sheets: in the order of the class. pictures: `<svg>` elements of some gradings. code: the submitted files
    of these. not_drawn: how many recordings have no picture because the page would become too large. ended:
    when this was read. before: sheets of an earlier run to compare with, by id.
    """

    course: str
    exercises: tuple[GradedExercise, ...]
    sheets: tuple[Sheet, ...]
    began: datetime
    ended: datetime
    pictures: Mapping[Key, tuple[str, ...]] = field(default_factory=dict)
    code: Mapping[Key, Code] = field(default_factory=dict)
    not_drawn: int = 0
    before: Mapping[str, Sheet] = field(default_factory=dict)

    def then(self, sheet: Sheet, mark: Mark) -> Mark | None:
        """The same person's mark of the earlier run."""
        marks = self.before[sheet.person.id].marks if sheet.person.id in self.before else ()
        return next((one for one in marks if one.exercise.id == mark.exercise.id), None)

    def marks(self, exercise: GradedExercise) -> Iterator[tuple[int, Mark]]:
        """Everybody's marks for the exercise, with their places in the class."""
        at = self.exercises.index(exercise)
        return ((place, sheet.marks[at]) for place, sheet in enumerate(self.sheets))


_ESCAPED = {ord(char): f"\\u{ord(char):04x}" for char in "<>&\u2028\u2029"}


def class_data(page: ClassPage) -> dict[str, Any]:
    """What the table shows; a mark is [verdict, points, max_points, seconds]."""
    return {
        "dated": any(sheet.lateness for sheet in page.sheets),
        "remarked": any(_said(sheet) for sheet in page.sheets),
        "compared": bool(page.before),
        "exercises": [
            {"id": one.id, "title": one.title, "max": one.max_points, "bonus": one.bonus}
            for one in page.exercises
        ],
        "people": [_person(sheet, page.before.get(sheet.person.id)) for sheet in page.sheets],
    }


def submission_data(page: ClassPage, place: int) -> dict[str, Any]:
    """All feedback for the person at that place, and the pictures."""
    sheet = page.sheets[place]
    return {
        "id": sheet.person.id,
        "name": sheet.person.name or sheet.person.id,
        "source": sheet.source,
        "summary": summary(sheet),
        "says": list(says(sheet)),
        "marks": [
            {
                **_mark(mark, page.then(sheet, mark)),
                "pictures": list(page.pictures.get((place, mark.exercise.id), ())),
                "code": _code(mark, page.code.get((place, mark.exercise.id), {})),
            }
            for mark in sheet.marks
        ],
    }


def as_json(data: object) -> str:
    """JSON that is safe inside a script element: it cannot end the element or begin a comment."""
    text = json.dumps(data, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    return text.translate(_ESCAPED)


def packed(data: object) -> str:
    """JSON, deflated, in base64: the browser unpacks it when somebody looks at it."""
    shrink = zlib.compressobj(9, zlib.DEFLATED, -15)
    text = json.dumps(data, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()
    return base64.b64encode(shrink.compress(text) + shrink.flush()).decode("ascii")


def places_of(mark: Mark) -> Iterator[tuple[str, int, str]]:
    """File, line (0: none) and text of each finding that names a place in the learner's files."""
    for check in mark.result.checks if mark.result else ():
        cause = why(check)
        for place in cause.where if cause else ():
            yield place.file, place.line or 0, cause.summary if cause else ""


def _code(mark: Mark, code: Code) -> list[dict[str, Any]]:
    found = tuple(places_of(mark))
    return [
        {
            "path": path,
            "lines": list(lines),
            "found": sorted({(line, words) for file, line, words in found if file == path and line}),
        }
        for path, lines in code.items()
    ]


def _person(sheet: Sheet, before: Sheet | None) -> dict[str, Any]:
    return {
        "id": sheet.person.id,
        "name": sheet.person.name or sheet.person.id,
        "state": sheet.state,
        "points": sheet.points,
        "max": sheet.max_points,
        "raw": sheet.raw_points,
        "before": before.points if before else None,
        "late": sheet.late,
        "lateness": sheet.lateness.seconds if sheet.lateness else 0,
        "said": " ".join(_said(sheet)),
        "seconds": round(sheet.seconds, 1),
        "marks": [
            [mark.verdict, mark.points, mark.max_points, round(mark.seconds, 1)] for mark in sheet.marks
        ],
    }


def _said(sheet: Sheet) -> list[str]:
    """People's comments and remarks, shown next to the points. Lateness has its own column."""
    return [*comments(replace(sheet, lateness=None)), *sheet.remarks]


def _mark(mark: Mark, then: Mark | None) -> dict[str, Any]:
    result = mark.result
    return {
        "id": mark.exercise.id,
        "title": mark.exercise.title,
        "bonus": mark.exercise.bonus,
        "verdict": mark.verdict,
        "headline": headline(mark),
        "total": total(mark),
        "before": f"{headline(then)} {total(then)}".strip() if then else "",
        "byHand": list(decisions(mark)),
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
        "points": earned_of(check),
        "why": _feedback(cause) if cause else None,
    }


def _feedback(feedback: Feedback) -> dict[str, Any]:
    parts = [[label, text] for label, text in labeled(feedback)]
    return {"summary": feedback.summary, "parts": parts, "details": list(feedback.details)}

"""The result that GitHub Classroom's grading reporter takes: JSON in base64, for one submission."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator
from typing import Any

from course.grading.result import CheckResult, Feedback, Outcome
from course.report.gradebook.sheets import INCOMPLETE, Mark, Sheet, tidy
from course.report.gradebook.words import NOTHING, text_of, why

VERSION = 1
_STATUS = {Outcome.PASSED: "pass", Outcome.FAILED: "fail", Outcome.SKIPPED: "fail", Outcome.ERROR: "error"}


def encoded(sheet: Sheet) -> str:
    """One line of base64, as a step's output holds it."""
    text = json.dumps(as_data(sheet), ensure_ascii=False, allow_nan=False)
    return base64.b64encode(text.encode("utf-8")).decode("ascii")


def as_data(sheet: Sheet) -> dict[str, Any]:
    """The result before it is encoded. What does not apply is left out: it is no test of this learner."""
    tests = [test for mark in sheet.marks for test in _tests(mark)]
    return {"version": VERSION, "status": _status(sheet), "max_score": sheet.judged_max, "tests": tests}


def _status(sheet: Sheet) -> str:
    if sheet.state == INCOMPLETE:
        return "error"
    needed = [mark for mark in sheet.marks if mark.counts and not mark.exercise.bonus]
    return "pass" if needed and all(mark.verdict == "passed" for mark in needed) else "fail"


def _tests(mark: Mark) -> Iterator[dict[str, Any]]:
    if mark.result is None:
        yield _test(mark.exercise.id, "fail", Feedback(NOTHING), 0, 0)
        return
    if mark.result.fault:
        yield _test(mark.exercise.id, "error", mark.result.fault, 0, 0)
    applicable = [check for check in mark.result.checks if check.outcome is not Outcome.NOT_APPLICABLE]
    # The whole exercise's time is told with its first check, so that the sum is right.
    times = [mark.seconds, *(0.0 for _ in applicable)]
    for check, seconds in zip(applicable, times, strict=False):
        earned = check.earned if mark.counts else 0
        yield _test(_name(mark, check), _STATUS[check.outcome], why(check), seconds, earned)


def _name(mark: Mark, check: CheckResult) -> str:
    return f"{mark.exercise.id}: {check.title}"


def _test(name: str, status: str, feedback: Feedback | None, seconds: float, earned: float) -> dict[str, Any]:
    place = feedback.where[0] if feedback and feedback.where else None
    return {
        "name": name,
        "status": status,
        "message": text_of(feedback) if feedback else None,
        "test_code": "",
        "filename": place.file if place else "",
        "line_no": (place.line or 0) if place else 0,
        "execution_time": "0" if status == "error" else f"{seconds:.1f}s",
        "score": tidy(earned),
    }

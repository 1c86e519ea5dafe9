"""For GitHub: annotations on the lines they name, files for Classroom, and the summary of a job."""

from __future__ import annotations

import base64
import json
import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from datetime import datetime, timezone
from typing import Any

from course.model.gradebook import GradedExercise
from course.model.result import CheckResult, Feedback, Location, Outcome
from course.report.gradebook.check_words import NOTHING, headline, score, text_of, why
from course.report.gradebook.letter import plain, section
from course.report.gradebook.sheets import EXCUSED, INCOMPLETE, Mark, Sheet, tidy

# GitHub shows no more for one step.
MOST = 10
_TEXT = {"%": "%25", "\r": "%0D", "\n": "%0A"}
_VALUE = {**_TEXT, ":": "%3A", ",": "%2C"}


@dataclass(frozen=True)
class _Found:
    """One thing that could be shown; `rank` sorts the most useful first."""

    rank: tuple[int, int]
    title: str
    feedback: Feedback
    place: Location | None


def commands(sheet: Sheet, place_in_repository: Callable[[str], str] = lambda file: file) -> list[str]:
    """Workflow commands, a line each, at most ten, most useful first.

    Failures with a file and a line come first. Every exercise's first failure comes before any second one,
    which often follows from it. place_in_repository: its argument is a file's place in the course home.
    """
    every = sorted(_found(sheet), key=lambda found: found.rank)
    chosen = list(_each_place_once(every))[:MOST]
    return [_command(found, place_in_repository) for found in chosen]


def command(title: str, feedback: Feedback, place: Location | None) -> str:
    """One workflow command. place: in the repository."""
    values = {"title": title}
    if place:
        values["file"] = place.file
    if place and place.line:
        values["line"] = str(place.line)
    told = ",".join(f"{name}={_escaped(value, _VALUE)}" for name, value in values.items())
    text = " ".join(part for part in (feedback.summary, feedback.advice) if part)
    return f"::error {told}::{_escaped(text, _TEXT)}"


def _found(sheet: Sheet) -> Iterator[_Found]:
    for mark in sheet.marks:
        if mark.result and mark.result.fault:
            yield _Found((_vagueness(None), 0), _title(mark), mark.result.fault, None)
        for order, check in enumerate(_failed(mark)):
            assert check.feedback is not None
            place = check.feedback.where[0] if check.feedback.where else None
            yield _Found((_vagueness(place), order), _title(mark, check), check.feedback, place)


def _failed(mark: Mark) -> Iterator[CheckResult]:
    checks = mark.result.checks if mark.result else ()
    return (check for check in checks if check.outcome is Outcome.FAILED and check.feedback)


def _vagueness(place: Location | None) -> int:
    return 2 if place is None else int(place.line is None)


def _each_place_once(every: Iterable[_Found]) -> Iterator[_Found]:
    """Only the first of several failures on one line: they are one thing to fix."""
    seen: set[tuple[Location | None, str]] = set()
    for found in every:
        key = (found.place, "" if found.place and found.place.line else found.feedback.summary)
        if key not in seen:
            seen.add(key)
            yield found


def _title(mark: Mark, check: CheckResult | None = None) -> str:
    return f"{mark.exercise.id}: {check.title if check else mark.exercise.title}"


def _command(found: _Found, place_in_repository: Callable[[str], str]) -> str:
    place = found.place and Location(place_in_repository(found.place.file), found.place.line)
    return command(found.title, found.feedback, place)


def _escaped(text: str, codes: dict[str, str]) -> str:
    return "".join(codes.get(character, character) for character in text)


VERSION = 1
_STATUS = {Outcome.PASSED: "pass", Outcome.FAILED: "fail", Outcome.SKIPPED: "fail", Outcome.ERROR: "error"}


_RESULT = "classroom50/result/v1"
# What the runner of Classroom 50 tells about a submission, in environment variables.
SUBMISSION = ("CLASSROOM", "ASSIGNMENT", "SUBMISSION_TAG", "USERNAME", "COMMIT_URL", "RELEASE_URL")


def classroom50(
    sheet: Sheet, told: Mapping[str, str], committed: datetime, graded: datetime
) -> dict[str, Any]:
    """result.json of Classroom 50 (classroom50/result/v1) for one submission.

    told: environment variables of its runner. committed: when the commit was made. Its points are whole
    numbers, and never more than the maximum. So ours are rounded (.5 up), with the exact ones in each test.
    """
    actor = told.get("GITHUB_ACTOR_ID", "")
    who = {"username": told.get("GITHUB_ACTOR", ""), "id": int(actor) if actor.isdecimal() else None}
    most = _whole(sheet.judged_max)
    return {
        "schema": _RESULT,
        "classroom": told["CLASSROOM"],
        "assignment": told["ASSIGNMENT"],
        "assignment_type": told.get("MODE") or "individual",
        "owner": told["USERNAME"],
        "submission": told["SUBMISSION_TAG"],
        "commit": told["COMMIT_URL"],
        "release": told["RELEASE_URL"],
        "review": told.get("REVIEW_URL") or told["COMMIT_URL"],
        "datetime": _utc(committed),
        "graded_at": _utc(graded),
        "score": min(_whole(sheet.judged_points), most),
        "max-score": most,
        "tests": [_classroom50_test(mark) for mark in sheet.marks if mark.counts],
        **({"submitted_by": who} if who["username"] else {}),
    }


def _classroom50_test(mark: Mark) -> dict[str, Any]:
    """One test per exercise, because a single check is often worth less than one point."""
    most = 0 if mark.exercise.bonus else _whole(mark.max_points or 0)
    return {
        "test-name": f"{mark.exercise.id}: {mark.exercise.title}",
        "passed": mark.verdict == "passed",
        "score": min(_whole(mark.points or 0), most),
        "max-score": most,
        "points": mark.points,
        "message": headline(mark),
    }


def _whole(points: float) -> int:
    return math.floor(points + 0.5)


def _utc(at: datetime) -> str:
    return at.astimezone(timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")


def encoded(sheet: Sheet) -> str:
    """The result as one line of base64, for a step's output."""
    text = json.dumps(as_data(sheet), ensure_ascii=False, allow_nan=False)
    return base64.b64encode(text.encode("utf-8")).decode("ascii")


def as_data(sheet: Sheet) -> dict[str, Any]:
    """The result before it is encoded. Checks that do not apply are not tests of this learner: left out."""
    tests = [test for mark in sheet.marks if mark.verdict != EXCUSED for test in _tests(mark)]
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
    # The first check gets the time of the whole exercise, so that the sum is right.
    times = [mark.seconds, *(0.0 for _ in applicable)]
    for check, seconds in zip(applicable, times, strict=False):
        earned = check.earned if mark.counts else 0
        yield _test(_title(mark, check), _STATUS[check.outcome], why(check), seconds, earned)


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


LIMIT = 1024 * 1024
# Bytes kept free for the note that says what was left out.
_NOTE_ROOM = 200


def job_summary(
    course: str, exercises: Iterable[GradedExercise], sheets: Iterable[Sheet], *, used: int = 0
) -> str:
    """The Markdown to append to the summary's file; empty if that is full.

    course, exercises: cleaned, like the sheets. used: bytes that are in the file already. If it does not fit,
    whole rows and whole exercises are left out at the end, and a note counts them.
    """
    room = LIMIT - used - _NOTE_ROOM
    if room < 0:
        return ""
    table, details = _Page(room), _Page(room)
    titles = ["id", "name", *(plain(exercise.id) for exercise in exercises), "total"]
    table.add(f"# {plain(course)}\n\n{_row(titles)}{_row(['---'] * len(titles))}")
    for sheet in sheets:
        table.add(_row(_cells(sheet)))
        for section_of_one in _details(sheet):
            details.add(section_of_one)
    details.shrink(table.room)
    return "".join((*table.pieces, *details.pieces, _note(table.left_out, details.left_out)))


class _Page:
    """Pieces of text in `room` bytes; after the first one that does not fit, none is accepted."""

    def __init__(self, room: int) -> None:
        self.pieces: list[str] = []
        self.room = room
        self.left_out = 0

    def add(self, piece: str) -> None:
        size = _size(piece)
        if self.left_out or size > self.room:
            self.left_out += 1
        else:
            self.pieces.append(piece)
            self.room -= size

    def shrink(self, room: int) -> None:
        """Drop pieces from the end until the others fit."""
        taken = sum(map(_size, self.pieces))
        while taken > room:
            taken -= _size(self.pieces.pop())
            self.left_out += 1


def _size(text: str) -> int:
    return len(text.encode("utf-8"))


def _note(rows: int, exercises: int) -> str:
    if not rows and not exercises:
        return ""
    missing = " and ".join(
        [f"{rows} rows of the table"] * bool(rows) + [f"details of {exercises} exercises"] * bool(exercises)
    )
    return f"\n\nGitHub shows at most 1 MiB. Left out here: {missing}. They are in results.json.\n"


def _cells(sheet: Sheet) -> Iterator[str]:
    yield from (plain(sheet.person.id), plain(sheet.person.name))
    yield from map(_verdict, sheet.marks)
    yield sheet.state if sheet.points is None else score(sheet.points, sheet.max_points)


def _verdict(mark: Mark) -> str:
    return f"{mark.verdict}, {score(mark.points, mark.max_points)}" if mark.counts else mark.verdict


def _details(sheet: Sheet) -> Iterator[str]:
    """The failed checks by exercise. The person's name is above the first one."""
    heading = f"\n## {plain(sheet.person.name or sheet.person.id)}\n"
    for mark in sheet.marks:
        if mark.verdict != "passed":
            yield "\n".join((heading, "\n\n".join(section(mark, "###")), ""))
            heading = ""


def _row(cells: Iterable[str]) -> str:
    return f"| {' | '.join(cells)} |\n"

"""GitHub's annotations: workflow commands on standard output, shown beside the lines they name."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

from course.grading.result import CheckResult, Feedback, Location, Outcome
from course.report.gradebook.sheets import Mark, Sheet

# More are not shown for one step.
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

    What names a file and a line comes first, and of each exercise its first failure before any second,
    since later ones often follow from it. place_in_repository: from a file's place in the course home.
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
    """Several failures at one line are one thing to mend."""
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

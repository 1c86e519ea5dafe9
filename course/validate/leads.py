"""Whether the feedback on a known mistake points at what the mistake changed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from difflib import SequenceMatcher
from pathlib import Path

from course.content import Mistake
from course.model.feedback import Location
from course.model.result import Outcome, Result
from course.spelling import listed

_NEAR = 3  # lines: a learner sees them together


def misled(result: Result, mistake: Mistake, before: Mapping[str, str], home: Path) -> str | None:
    """In words, what the feedback points at instead of the mistake. before: edited files as they were."""
    check = next((one for one in result.checks if one.id == mistake.caught_by), None)
    if check is None or check.outcome is not Outcome.FAILED or check.feedback is None:
        return None
    places = check.feedback.where
    points = f"`{check.id}` points at {listed(list(map(str, places)), 'no line')}"
    if mistake.leads_to:
        found = any(mistake.leads_to in f"{place.file}: {_line(home, place)}" for place in places)
        return None if found else f'{points}, not at "{mistake.leads_to}"'
    changed = {file: [*_changed(text, _text(home / file))] for file, text in before.items()}
    if not places or not any(changed.values()) or any(_near(place, changed) for place in places):
        return None
    return f"{points}, not at what the mistake changes. If that is right, say so in `leads_to`"


def _changed(before: str, now: str) -> Iterator[int]:
    """Numbers of the lines that differ now, or that are next to removed ones."""
    matcher = SequenceMatcher(None, before.splitlines(), now.splitlines(), autojunk=False)
    for what, _, _, begin, end in matcher.get_opcodes():
        if what != "equal":
            yield from range(begin + 1, max(end, begin + 1) + 1)


def _near(place: Location, changed: Mapping[str, list[int]]) -> bool:
    lines = changed.get(place.file, [])
    return any(place.line is None or abs(place.line - line) <= _NEAR for line in lines)


def _line(home: Path, place: Location) -> str:
    lines = _text(home / place.file).splitlines() if place.line else []
    return lines[place.line - 1].strip() if place.line and place.line <= len(lines) else ""


def _text(file: Path) -> str:
    return file.read_text(encoding="utf-8", errors="replace") if file.is_file() else ""

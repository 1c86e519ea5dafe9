"""Finds the exercise that a learner means: its id, or an abbreviation that fits only one."""

from __future__ import annotations

import re
from collections.abc import Iterable

from course.content.names import nearest
from course.errors import UsageError


def chapter_number(wanted: str) -> int | None:
    """18 for `18-publisher`, `18-pub` and `18`; None when no number leads."""
    match = re.match(r"(\d+)(-|$)", wanted)
    return int(match[1]) if match else None


def tidy(wanted: str) -> str:
    """What is typed in a hurry, as ids are written."""
    return wanted.strip().lower().replace("_", "-").replace(" ", "-")


def choose(wanted: str, ids: Iterable[str]) -> str | None:
    """The one id that `wanted` is or abbreviates, or None. Raises UsageError when several fit."""
    known = tuple(ids)
    for fits in (_is_id, _is_name, _is_chapter, _begins_id, _begins_name):
        found = [candidate for candidate in known if wanted and fits(wanted, candidate)]
        if len(found) == 1:
            return found[0]
        if found:
            raise UsageError(f"`{wanted}` fits several exercises", f"say which one: {_listed(found)}")
    return None


def unknown(wanted: str, ids: Iterable[str]) -> UsageError:
    """No exercise fits: name the likeliest, by the whole id or by the part after the number."""
    known = tuple(ids)
    names = {_name(candidate): candidate for candidate in known}
    alike = [*nearest(wanted, known), *(names[name] for name in nearest(_name(wanted), names))]
    guess = f"did you mean {' or '.join(list(dict.fromkeys(alike))[:3])}? " if alike else ""
    return UsageError(f"there is no exercise `{wanted}`", f"{guess}`ros2course list` shows them all")


def _listed(ids: list[str]) -> str:
    return ", ".join(ids[:6]) + (", ..." if len(ids) > 6 else "")


def _name(exercise: str) -> str:
    return re.sub(r"^\d+-", "", exercise)


def _is_id(wanted: str, candidate: str) -> bool:
    return _padded(wanted) == candidate


def _is_name(wanted: str, candidate: str) -> bool:
    return wanted == _name(candidate)


def _is_chapter(wanted: str, candidate: str) -> bool:
    return _padded(wanted) == candidate[:2]


def _begins_id(wanted: str, candidate: str) -> bool:
    return "-" in wanted and candidate.startswith(_padded(wanted))


def _begins_name(wanted: str, candidate: str) -> bool:
    return _name(candidate).startswith(wanted)


def _padded(wanted: str) -> str:
    """`2-script` as `02-script`."""
    return re.sub(r"^(\d)(?=-|$)", r"0\1", wanted)

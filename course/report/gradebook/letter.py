"""The feedback file for one learner, in Markdown that also reads well as plain text."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from course.model.result import CheckResult, Feedback
from course.report.gradebook.check_words import (
    NOTHING,
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

# An invisible character that ends a word: with it, no renderer sees an address or a mention.
_BREAK = "\u2060"
_ENTITIES = {"&": "&amp;", "<": "&lt;", ">": "&gt;"}
# An underscore inside a word is not markup, and ROS names are full of them.
_MARKS = re.compile(r"[\\`*\[\]|~$]|(?<![^\W_])_|_(?![^\W_])")
_AUTOMATIC = re.compile(
    r"(?<=@)(?=\w)|(?<=:)(?=//)|(?<=www)(?=\.)|(?<=#)(?=\d)|(?<=GH)(?=-\d)", re.IGNORECASE
)
# Characters that would begin a list or a heading.
_BEGINNING = re.compile(r"^(?:\d+(?=[.)](?!\S))|(?=[-+#=]))")
# A tag that stands by itself is shown as code, which reads well as plain text, too.
_TAG = re.compile(r"(?<![^\s(])(<[^\s`<>]+>(?:[^\s`<>]*</[^\s`<>]+>)?)(?![^\s).,:;])")
_CODE = re.compile(rf"`([^`]+)`|{_TAG.pattern}")
_QUOTES = re.compile(r"`+")


def plain(text: str) -> str:
    """One line of text in which nothing is markup."""
    return _BEGINNING.sub(r"\g<0>\\", _inert(text))


def prose(text: str) -> str:
    """One line of text; text in `backquotes` is code, and nothing else is markup."""
    parts = text.split("`")
    if len(parts) % 2 == 0 or any(not part.strip() for part in parts[1::2]):
        return plain(text)
    parts = [part for part in _CODE.split(text) if part is not None]  # one of the two groups is None
    shown = (code(part) if odd % 2 else _harmless(part) or _gap(odd, parts) for odd, part in enumerate(parts))
    return _BEGINNING.sub(r"\g<0>\\", "".join(shown))


def code(text: str) -> str:
    """One line of text as code."""
    fence = "`" * (_longest(text) + 1)
    pad = " " if text.startswith("`") or text.endswith("`") else ""
    return f"{fence}{pad}{text}{pad}{fence}".replace("\n", " ")


def fenced(lines: Iterable[str], indent: str = "") -> str:
    """Lines as a code block that none of the lines can end."""
    every = [piece for line in lines for piece in line.split("\n")]
    fence = "`" * max(3, max(map(_longest, every), default=0) + 1)
    return "\n".join(f"{indent}{line}".rstrip() for line in (f"{fence}text", *every, fence))


def _inert(text: str) -> str:
    return "".join(code(part) if odd % 2 else _harmless(part) for odd, part in enumerate(_TAG.split(text)))


def _harmless(text: str) -> str:
    named = re.sub(r"[&<>]", lambda match: _ENTITIES[match[0]], text.replace("\n", " "))
    return _AUTOMATIC.sub(_BREAK, _MARKS.sub(r"\\\g<0>", named))


def _longest(text: str) -> int:
    return max((len(run) for run in _QUOTES.findall(text)), default=0)


def _gap(index: int, parts: list[str]) -> str:
    """A space between two pieces of code, which would otherwise become one."""
    return " " if 0 < index < len(parts) - 1 else ""


_INDENT = "  "


def letter(sheet: Sheet, course: str) -> str:
    """The whole file. course: its title, clean."""
    blocks = [f"# Feedback for {plain(sheet.person.name or sheet.person.id)}", *_opening(sheet, course)]
    for mark in sheet.marks:
        blocks += section(mark, "##")
    return "\n\n".join(blocks) + "\n"


def section(mark: Mark, heading: str) -> Iterator[str]:
    """How one exercise ended, as blocks. heading: `##` or deeper."""
    yield f"{heading} {plain(mark.exercise.id)}: {plain(mark.exercise.title)}"
    points = total(mark)
    bonus = " It is a bonus." if mark.exercise.bonus else ""
    yield f"**{headline(mark)}**{f': {points}' if points else ''}.{bonus}"
    yield from map(prose, decisions(mark))
    if mark.result is None:
        yield NOTHING
        return
    if mark.result.fault:
        yield from _feedback(mark.result.fault, "")
    for check in mark.result.checks:
        yield from _check(check)
    yield from (f"Note: {prose(note)}" for note in mark.result.notes)


def _opening(sheet: Sheet, course: str) -> Iterator[str]:
    yield f"{plain(course)}: {plain(summary(sheet))}."
    if sheet.source:
        yield f"Handed in: {code(sheet.source)}"
    yield from map(prose, says(sheet))


def _check(check: CheckResult) -> Iterator[str]:
    points = earned_of(check)
    yield f"- **{mark_of(check)}** {prose(check.title)}{f' ({points})' if points else ''}"
    feedback = why(check)
    if feedback:
        yield from _feedback(feedback, _INDENT)


def _feedback(feedback: Feedback, indent: str) -> Iterator[str]:
    yield f"{indent}{prose(feedback.summary)}"
    parts = [f"{indent}- {label}: {_part(label, text)}" for label, text in labeled(feedback)]
    if parts:
        yield "\n".join(parts)
    if feedback.details:
        yield fenced(feedback.details, indent)


def _part(label: str, text: str) -> str:
    return code(text) if label == "in" else prose(text)

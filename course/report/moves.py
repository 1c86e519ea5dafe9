"""Whose marks moved, and why: a table for the terminal."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from rich.console import Console
from rich.text import Text

from course.report import safe
from course.report.console import put, put_prose


@dataclass(frozen=True)
class Row:
    """One grading. name: whose it is. reasons: one line for each check that moved."""

    name: str
    exercise: str
    before: float
    after: float
    reasons: Sequence[str]


def render_moves(console: Console, rows: Sequence[Row], judged: int) -> None:
    """Each grading whose points moved, with its reasons below it, and a last line."""
    width = max((len(safe.one_line(row.name)) for row in rows), default=0)
    for row in rows:
        who = safe.one_line(row.name).ljust(width)
        put(console, Text(f"  {who}  {safe.one_line(row.exercise)}  {row.before:g} → {row.after:g}"))
        for reason in row.reasons:
            put_prose(console, safe.paragraph(reason), first="      ")
    if rows:
        put(console)
    moved = f"{len(rows)} of them moved" if rows else "none of them moved"
    put(console, f"{judged} gradings were judged again; {moved}.")


def render_lacking(console: Console, lines: Sequence[tuple[str, str, str]], command: str) -> None:
    """Gradings that stay as they were: person, exercise and why. command: what grades them anew."""
    if not lines:
        return
    put(console)
    put(console, f"{len(lines)} stay as they were, because their evidence does not suffice:")
    for person, exercise, why in lines:
        put_prose(console, safe.paragraph(why), first=f"  {safe.one_line(person)}  {exercise}  ")
    put(console)
    put_prose(console, f"To grade those anew: {command}")

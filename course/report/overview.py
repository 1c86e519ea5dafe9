"""The list of chapters and exercises with what was reached in each."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import groupby

from rich.console import Console
from rich.text import Text

from course.report import safe
from course.report.console import number, put

MARKS = {"passed": ("ok", "green"), "tried": ("no", "red"), "begun": ("..", "yellow"), "new": ("  ", "")}
TO_READ = "to read only: it is shown on the way"
LEGEND = "ok passed   no not passed yet   .. begun   > where you are"


@dataclass(frozen=True)
class Row:
    """One exercise. `state` is new, begun, tried or passed; points are None before the first check."""

    chapter: str
    exercise: str
    title: str
    state: str
    current: bool = False
    best: float | None = None
    most: float | None = None


def render_list(console: Console, rows: Iterable[Row], chapters: Iterable[str] = ()) -> None:
    """Chapters with their exercises, one line each, and the sum at the end.

    chapters: all of them, in their order, also those without exercises; those of the rows if left out.
    """
    every = list(rows)
    width = max((len(row.exercise) for row in every), default=0)
    members = {name: list(those) for name, those in groupby(every, key=lambda row: row.chapter)}
    for chapter in tuple(chapters) or members:
        put(console, Text(safe.one_line(chapter), "bold"))
        for row in members.get(chapter, ()):
            put(console, _line(console, row, width))
        if chapter not in members:
            put(console, f"      {TO_READ}", "dim")
    passed = sum(row.state == "passed" for row in every)
    put(console)
    put(console, f"{passed} of {len(every)} passed.", "bold")
    put(console, LEGEND, "dim")


def _line(console: Console, row: Row, width: int) -> Text:
    mark, style = MARKS[row.state]
    points = _points(row)
    here = ">" if row.current else " "
    room = max(console.width - width - len(points) - 11, 10)
    title = Text(safe.one_line(row.title))
    title.truncate(room, overflow="ellipsis", pad=True)
    name = f"  {row.exercise.ljust(width)}  "
    line = Text.assemble((f"{here} ", "bold"), (mark, style), name, title, f"  {points}")
    line.rstrip()
    return line


def _points(row: Row) -> str:
    if row.best is None:
        return ""
    most = f" of {number(row.most)}" if row.most is not None else ""
    return f"{number(row.best)}{most}"

"""Grading a class in the terminal: what was found, how far it is, and how it ended."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from rich.console import Console
from rich.table import Table
from rich.text import Text

from course.grading.result import Result, Verdict
from course.report import safe, tally
from course.report.console import put, put_prose
from course.report.tally import progress

__all__ = ["Row", "Tally", "line_of", "progress", "render_end", "render_plan"]

_MARKS = {
    Verdict.PASSED: "passed",
    Verdict.NOT_PASSED: "not passed",
    Verdict.NOT_APPLICABLE: "not applicable",
    Verdict.NOT_AVAILABLE: "not available here",
    Verdict.OUR_ERROR: "our error",
}


@dataclass(frozen=True)
class Row:
    """One submission as it was found. Texts are safe to show. remarks: what is to be said of it."""

    person: str
    name: str
    source: str
    kind: str
    exercises: Sequence[str]
    remarks: Sequence[str] = ()


def render_plan(console: Console, rows: Sequence[Row], remarks: Sequence[str]) -> None:
    """A table of what was found where, and what is wrong with it."""
    table = Table(box=None, pad_edge=False, header_style="bold")
    for title in ("id", "name", "what", "exercises", "from"):
        table.add_column(title, overflow="fold")
    for row in rows:
        cells = (row.person, row.name, row.kind, _exercises(row.exercises), row.source)
        table.add_row(*(Text(safe.one_line(cell)) for cell in cells))
    console.print(table)
    for row in rows:
        for remark in row.remarks:
            put_prose(console, safe.paragraph(remark), first=f"  {safe.one_line(row.person)}: ")
    for remark in remarks:
        put_prose(console, safe.paragraph(remark))
    graded = sum(bool(row.exercises) for row in rows)
    gradings = sum(len(row.exercises) for row in rows)
    put(console)
    found = f"{_counted(len(rows), 'submission')}, {graded} of them with something to grade"
    put(console, f"{found}: {_counted(gradings, 'grading')}.")


def _counted(count: int, noun: str) -> str:
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"


def _exercises(ids: Sequence[str]) -> str:
    return ", ".join(ids) if len(ids) <= 4 else f"{', '.join(ids[:3])} and {len(ids) - 3} more"


class Tally(tally.Tally):
    """Gradings, by their verdicts."""

    def add(self, result: Result) -> None:
        self.count(_MARKS[result.verdict])


def line_of(person: str, result: Result) -> str:
    """One grading in one line."""
    points = f"{result.points:g} of {result.max_points:g}" if result.checks else "-"
    return safe.one_line(f"{person}  {result.exercise}  {_MARKS[result.verdict]}  {points}")


def render_end(
    console: Console, verdicts: Sequence[tuple[str, int]], files: Sequence[tuple[str, str]]
) -> None:
    """How many ended how, and where to read on. files: path and what it is."""
    put(console, ", ".join(f"{count} {verdict}" for verdict, count in verdicts) or "Nothing was graded.")
    put(console)
    width = max(len(name) for name, _ in files)
    for name, what in files:
        put(console, f"  {name.ljust(width)}  {what}")

"""Grading a class in the terminal: what was found, how it ended, and whose marks moved later."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from rich.console import Console
from rich.table import Table
from rich.text import Text

from course.model.result import Result
from course.report import activity, sanitize
from course.report.console import put, put_prose
from course.spelling import counted

if TYPE_CHECKING:
    from course.grading.judge.regraded import Move


@dataclass(frozen=True)
class SubmissionRow:
    """One submission as it was found. Texts are safe to show. remarks: what to say about it."""

    person: str
    name: str
    source: str
    kind: str
    exercises: Sequence[str]
    remarks: Sequence[str] = ()


def render_plan(console: Console, rows: Sequence[SubmissionRow], remarks: Sequence[str]) -> None:
    """A table of what was found where, and what is wrong with it."""
    table = Table(box=None, pad_edge=False, header_style="bold")
    for title in ("id", "name", "what", "exercises", "from"):
        table.add_column(title, overflow="fold")
    for row in rows:
        cells = (row.person, row.name, row.kind, _exercises(row.exercises), row.source)
        table.add_row(*(Text(sanitize.one_line(cell)) for cell in cells))
    console.print(table)
    for row in rows:
        for remark in row.remarks:
            put_prose(console, sanitize.paragraph(remark), first=f"  {sanitize.one_line(row.person)}: ")
    for remark in remarks:
        put_prose(console, sanitize.paragraph(remark))
    graded = sum(bool(row.exercises) for row in rows)
    gradings = sum(len(row.exercises) for row in rows)
    put(console)
    found = f"{counted(len(rows), 'submission')}, {graded} of them with something to grade"
    put(console, f"{found}: {counted(gradings, 'grading')}.")


def _exercises(ids: Sequence[str]) -> str:
    return ", ".join(ids) if len(ids) <= 4 else f"{', '.join(ids[:3])} and {len(ids) - 3} more"


class GradingTally(activity.Tally):
    """Gradings, by their verdicts."""

    def add(self, result: Result) -> None:
        self.count(result.verdict.value)


def line_of(person: str, result: Result) -> str:
    """One grading in one line."""
    points = f"{result.points:g} of {result.max_points:g}" if result.checks else "-"
    return sanitize.one_line(f"{person}  {result.exercise}  {result.verdict.value}  {points}")


def render_end(
    console: Console, verdicts: Sequence[tuple[str, int]], files: Sequence[tuple[str, str]]
) -> None:
    """How many gradings ended with each verdict, and where to read more. files: path and what it is."""
    put(console, ", ".join(f"{count} {verdict}" for verdict, count in verdicts) or "Nothing was graded.")
    put(console)
    width = max((len(name) for name, _ in files), default=0)
    for name, what in files:
        put(console, f"  {name.ljust(width)}  {what}")


@dataclass(frozen=True)
class Moved:
    """A grading whose marks changed. person, name: the learner's. moves: the checks whose result changed.

    before, after: points. most_before, most_after: the maximum.
    """

    person: str
    name: str
    exercise: str
    before: float
    after: float
    most_before: float
    most_after: float
    moves: Sequence[Move]

    @property
    def same(self) -> bool:
        return (self.before, self.most_before) == (self.after, self.most_after)


def render_moves(console: Console, rows: Sequence[Moved], judged: int) -> None:
    """Each grading that changed, with the reasons below it, and a last line."""
    width = max((len(sanitize.one_line(row.name)) for row in rows), default=0)
    for row in rows:
        who = sanitize.one_line(row.name).ljust(width)
        marks = _marks(row)
        put(console, Text(f"  {who}  {sanitize.one_line(row.exercise)}  {marks}"))
        for move in row.moves:
            put_prose(console, sanitize.paragraph(f"{move.title}: {move.why}"), first="      ")
    if rows:
        put(console)
    moved = sum(not row.same for row in rows)
    told = f"{moved} of them changed" if moved else "none of them changed"
    if len(rows) > moved:
        told += f", and {len(rows) - moved} reached the same points in a different way"
    put(console, f"{judged} gradings were judged again; {told}.")


def _marks(row: Moved) -> str:
    after = f"{row.after:g} of {row.most_after:g}"
    return f"{after}, as before" if row.same else f"{row.before:g} of {row.most_before:g} → {after}"


def render_lacking(console: Console, lines: Sequence[tuple[str, str, str]], command: str) -> None:
    """Gradings that stay as they were: person, exercise and reason. command: it grades them again."""
    if not lines:
        return
    put(console)
    put(console, f"{len(lines)} stay as they were, because the evidence is not enough:")
    for person, exercise, why in lines:
        put_prose(console, sanitize.paragraph(why), first=f"  {sanitize.one_line(person)}  {exercise}  ")
    put(console)
    put_prose(console, f"To grade those again: {command}")

"""The proofs of a course in the terminal: a table, what was found, and how it ended. Works without colour."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby

from rich.console import Console
from rich.table import Table
from rich.text import Text

from course.report import safe
from course.report.console import number, put, put_prose, with_code
from course.report.validation.model import Count, Note, Row

_COLUMNS = ("exercise", "solution", "others", "starter", "mistakes", "checks", "points", "seconds")
_TRY = "try  "


def render_table(console: Console, rows: Sequence[Row], *, again: int = 0) -> None:
    """again: how many gradings were done again."""
    # At 80 columns even the longest ids leave room for all.
    table = Table(box=None, pad_edge=False, collapse_padding=True, header_style="bold")
    for title in _COLUMNS:
        table.add_column(title, justify="left" if title == "exercise" else "right", no_wrap=True)
    for row in rows:
        table.add_row(safe.one_line(row.exercise), *_cells(row))
    if len(rows) > 1:
        table.add_section()
        table.add_row("in all", *_cells(_sum(rows)))
    console.print(table)
    if again:
        put(console)
        what = "1 grading was" if again == 1 else f"{again} gradings were"
        put_prose(console, f"{what} done again, with less beside it: the machine had been too busy to judge.")


def render_notes(console: Console, notes: Sequence[Note]) -> None:
    """All that was found, by file and line."""
    for file, found in groupby(sorted(notes, key=_place), key=lambda note: note.file):
        put(console)
        put(console, safe.one_line(file), "bold")
        for note in found:
            first = f"  {note.line or '':>4}  "
            put_prose(console, with_code(console, safe.paragraph(note.what)), first=first)
            if note.next_step:
                step = with_code(console, safe.paragraph(note.next_step))
                put_prose(console, step, first=" " * len(first) + _TRY)


def render_end(console: Console, found: int, rows: Sequence[Row], *, stopped: bool = False) -> None:
    """In one line how it ended, and what could not be told."""
    counts = [count for row in rows for count in row.counts]
    done, total = sum(count.done for count in counts), sum(count.total for count in counts)
    for lack in dict.fromkeys(row.missing for row in rows if row.missing):
        put(console)
        named = ", ".join(row.exercise for row in rows if row.missing == lack)
        put_prose(console, with_code(console, safe.paragraph(f"Not available here: {named}. {lack}")))
    put(console)
    if stopped:
        put(console, f"Stopped: {done} of {total} proofs were known.")
    put(console, Text(_ending(found, done, total), "red" if found else "green" if done == total else ""))


def _ending(found: int, done: int, total: int) -> str:
    held = "All proofs hold." if done == total else f"{done} of {total} proofs are done, and hold."
    if found:
        return "1 thing was found." if found == 1 else f"{found} things were found."
    return held if total else "Nothing was found."


def _place(note: Note) -> tuple[str, int]:
    return note.file, note.line or 0


def _cells(row: Row) -> list[Text]:
    points = Text("" if row.points is None else number(row.points))
    if row.missing and not any(count.done for count in row.counts):
        return [Text("not here", "yellow"), *[Text("")] * 6]
    checks = Text(f"{row.covered}/{row.checks}" if row.checks else "", _style(row.covered == row.checks))
    return [*map(_cell, row.counts), checks, points, Text(f"{row.seconds:.1f}")]


def _cell(count: Count) -> Text:
    if not count.total:
        return Text("-", "dim")
    wrong = count.done - count.held
    told = (
        f"{count.held}/{count.total}" if count.total > 1 else "no" if wrong else "ok" if count.held else ".."
    )
    return Text(told, _style(not wrong))


def _style(good: bool) -> str:
    return "" if good else "red"


def _sum(rows: Sequence[Row]) -> Row:
    kinds = [_total(each) for each in zip(*(row.counts for row in rows), strict=True)]
    solution, alternatives, starter, mistakes = kinds
    points = sum(row.points or 0 for row in rows)
    covered, checks = sum(row.covered for row in rows), sum(row.checks for row in rows)
    seconds = sum(row.seconds for row in rows)
    return Row("in all", solution, alternatives, starter, mistakes, covered, checks, points, seconds)


def _total(counts: Sequence[Count]) -> Count:
    held, done = sum(one.held for one in counts), sum(one.done for one in counts)
    return Count(held, done, sum(one.total for one in counts))

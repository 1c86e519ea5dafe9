"""Weakened graders in the terminal: how many were noticed, and each that was not. Works without colour."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby

from rich.console import Console
from rich.table import Table
from rich.text import Text

from course.report import safe
from course.report.console import put, put_prose, with_code

_COLUMNS = ("exercise", "mutants", "killed", "broken", "endless", "survived", "recorded", "seconds")
_NOT_ASKED = "`validate` without `--mutate` first: it was left out"


@dataclass(frozen=True)
class MutantsRow:
    """One exercise. recorded, kept: recordings made now, and found. recording, judging: seconds.

    problems: why the grader, or some proof of it, could not be judged.
    """

    exercise: str
    killed: int
    broken: int
    endless: int
    survived: int
    recorded: int
    kept: int
    recording: float
    judging: float
    problems: Sequence[str] = ()

    @property
    def mutants(self) -> int:
        return self.killed + self.broken + self.endless + self.survived


@dataclass(frozen=True)
class Survivor:
    """A change that nothing noticed. file: as it is shown. what: was done. checks: that use this line."""

    file: str
    line: int
    exercise: str
    checks: Sequence[str]
    what: str
    before: str
    after: str
    next_step: str


def render_mutants(console: Console, rows: Sequence[MutantsRow], survivors: Sequence[Survivor]) -> None:
    """A table, what could not be judged, the survivors by file and line, and how it ended."""
    console.print(_table(rows))
    for row in rows:
        for problem in row.problems:
            put(console)
            put_prose(console, with_code(console, safe.paragraph(problem)))
            put_prose(console, with_code(console, _NOT_ASKED), first="  try  ")
    ordered = sorted(survivors, key=lambda one: (one.file, one.line))
    for file, each in groupby(ordered, key=lambda one: one.file):
        put(console)
        put(console, safe.one_line(file), "bold")
        for survivor in each:
            _render(console, survivor)
    put(console)
    put(console, _ending(rows))


def _table(rows: Sequence[MutantsRow]) -> Table:
    table = Table(box=None, pad_edge=False, header_style="bold")
    for title in _COLUMNS:
        table.add_column(title, justify="left" if title == "exercise" else "right", no_wrap=True)
    for row in rows:
        table.add_row(safe.one_line(row.exercise), *_cells(row))
    if len(rows) > 1:
        table.add_section()
        table.add_row("in all", *_cells(_sum(rows)))
    return table


def _cells(row: MutantsRow) -> list[Text]:
    counts = [Text(f"{count}") for count in (row.mutants, row.killed, row.broken, row.endless)]
    survived = Text(f"{row.survived}", "red" if row.survived else "")
    recorded = Text(f"{row.recorded}/{row.recorded + row.kept}")
    return [*counts, survived, recorded, Text(f"{row.recording:.0f}+{row.judging:.1f}")]


def _sum(rows: Sequence[MutantsRow]) -> MutantsRow:
    return MutantsRow(
        "in all",
        killed=sum(row.killed for row in rows),
        broken=sum(row.broken for row in rows),
        endless=sum(row.endless for row in rows),
        survived=sum(row.survived for row in rows),
        recorded=sum(row.recorded for row in rows),
        kept=sum(row.kept for row in rows),
        recording=sum(row.recording for row in rows),
        judging=sum(row.judging for row in rows),
    )


def _render(console: Console, one: Survivor) -> None:
    first = f"  {one.line:>4}  "
    hanging = " " * len(first)
    checks = ", ".join(f"`{check}`" for check in one.checks)
    head = with_code(console, safe.one_line(f"{one.exercise}, {checks}: {one.what}"))
    put_prose(console, head, first=first)
    put_prose(console, safe.one_line(one.before), first=f"{hanging}- ")
    put_prose(console, safe.one_line(one.after), first=f"{hanging}+ ")
    put_prose(console, with_code(console, safe.paragraph(one.next_step)), first=f"{hanging}try  ")


def _ending(rows: Sequence[MutantsRow]) -> Text:
    survived, mutants = sum(row.survived for row in rows), sum(row.mutants for row in rows)
    if survived:
        return Text(f"{survived} of {mutants} mutants survived: a mistake is missing for each.", "red")
    if any(row.problems for row in rows):
        return Text("Not everything could be judged.", "red")
    noticed = f"All {mutants} mutants were noticed."
    return Text(noticed if mutants else "There was nothing to mutate.", "green")

"""How `validate` shows its results: a table in the terminal, JUnit XML, GitHub's workflow commands.

Texts are cleaned when they are shown.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import datetime
from itertools import groupby

from rich.console import Console
from rich.table import Table
from rich.text import Text

from course.model.feedback import Feedback, Location
from course.report import sanitize
from course.report.console import number, put, put_prose, with_code
from course.report.gradebook import github, junit
from course.report.gradebook.cleaning import Cleaner


@dataclass(frozen=True)
class Note:
    """Something that was found. file: as it is shown, relative if that is shorter. line: from 1."""

    file: str
    line: int | None
    what: str
    next_step: str | None
    exercise: str | None = None


@dataclass(frozen=True)
class Count:
    """Proofs of one kind: how many succeeded (`held`), how many are done, and how many there are."""

    held: int = 0
    done: int = 0
    total: int = 0


@dataclass(frozen=True)
class ProofRow:
    """One exercise. covered: how many of its checks failed for a known mistake. missing: on this machine."""

    exercise: str
    solution: Count
    alternatives: Count
    starter: Count
    mistakes: Count
    covered: int
    checks: int
    points: float | None
    seconds: float
    missing: str | None = None

    @property
    def counts(self) -> tuple[Count, ...]:
        return (self.solution, self.alternatives, self.starter, self.mistakes)


@dataclass(frozen=True)
class ProofCase:
    """One proof as a test case. notes: what was found; skipped: why it was not judged, else None."""

    exercise: str
    name: str
    seconds: float
    notes: Sequence[Note] = ()
    skipped: str | None = None


_COLUMNS = ("exercise", "solution", "others", "starter", "mistakes", "checks", "points", "seconds")
_TRY = "try  "


def render_table(console: Console, rows: Sequence[ProofRow], *, again: int = 0) -> None:
    """again: how many gradings were repeated."""
    # With 80 columns, even the longest ids leave room for everything.
    table = Table(box=None, pad_edge=False, collapse_padding=True, header_style="bold")
    for title in _COLUMNS:
        table.add_column(title, justify="left" if title == "exercise" else "right", no_wrap=True)
    for row in rows:
        table.add_row(sanitize.one_line(row.exercise), *_cells(row))
    if len(rows) > 1:
        table.add_section()
        table.add_row("in all", *_cells(_sum(rows)))
    console.print(table)
    if again:
        put(console)
        what = "1 grading was" if again == 1 else f"{again} gradings were"
        put_prose(console, f"{what} done again: the machine was too busy, or the course itself failed.")


def render_notes(console: Console, notes: Sequence[Note]) -> None:
    """Everything that was found, by file and line."""
    for file, found in groupby(sorted(notes, key=_place), key=lambda note: note.file):
        put(console)
        put(console, sanitize.one_line(file), "bold")
        for note in found:
            first = f"  {note.line or '':>4}  "
            put_prose(console, with_code(console, sanitize.paragraph(note.what)), first=first)
            if note.next_step:
                step = with_code(console, sanitize.paragraph(note.next_step))
                put_prose(console, step, first=" " * len(first) + _TRY)


def render_end(console: Console, found: int, rows: Sequence[ProofRow], *, stopped: bool = False) -> None:
    """How it ended, in one line, and what could not be proven on this machine."""
    counts = [count for row in rows for count in row.counts]
    done, total = sum(count.done for count in counts), sum(count.total for count in counts)
    for lack in dict.fromkeys(row.missing for row in rows if row.missing):
        put(console)
        named = ", ".join(row.exercise for row in rows if row.missing == lack)
        put_prose(console, with_code(console, sanitize.paragraph(f"Not available here: {named}. {lack}")))
    put(console)
    if stopped:
        put(console, f"Stopped: {done} of {total} proofs were known.")
    put(console, Text(_ending(found, done, total), "red" if found else "green" if done == total else ""))


def _ending(found: int, done: int, total: int) -> str:
    held = "All proofs hold." if done == total else f"{done} of {total} proofs are done, and hold."
    if found:
        return "1 problem was found." if found == 1 else f"{found} problems were found."
    return held if total else "No problems were found."


def _place(note: Note) -> tuple[str, int]:
    return note.file, note.line or 0


def _cells(row: ProofRow) -> list[Text]:
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


def _sum(rows: Sequence[ProofRow]) -> ProofRow:
    kinds = [_total(each) for each in zip(*(row.counts for row in rows), strict=True)]
    solution, alternatives, starter, mistakes = kinds
    points = sum(row.points or 0 for row in rows)
    covered, checks = sum(row.covered for row in rows), sum(row.checks for row in rows)
    seconds = sum(row.seconds for row in rows)
    return ProofRow("in all", solution, alternatives, starter, mistakes, covered, checks, points, seconds)


def _total(counts: Sequence[Count]) -> Count:
    held, done = sum(one.held for one in counts), sum(one.done for one in counts)
    return Count(held, done, sum(one.total for one in counts))


FILES = "files"


def as_junit(name: str, began: datetime, cases: Sequence[ProofCase], notes: Sequence[Note]) -> Iterator[str]:
    """A suite for each exercise with a case for each proof, and one suite for errors in files.

    notes: those that belong to no case.
    """
    ordered = sorted(cases, key=lambda case: case.exercise)
    suites = [junit.Suite(FILES, tuple(_of_files(notes)))]
    for exercise, each in groupby(ordered, key=lambda case: case.exercise):
        suites.append(junit.Suite(exercise, tuple(map(_case, each))))
    return junit.document(name, began, lambda: suites)


def annotated(notes: Sequence[Note]) -> list[str]:
    """As many as GitHub shows, those with a line first. Files are relative to the repository."""
    ordered = sorted(notes, key=lambda note: note.line is None)
    return [_command(note) for note in ordered[: github.MOST]]


def _command(note: Note) -> str:
    told = _feedback(note)
    return github.command(note.exercise or "course", told, told.where[0])


def _of_files(notes: Sequence[Note]) -> Iterator[junit.Case]:
    for note in notes:
        yield junit.Case(FILES, f"{note.file}: {note.what}", "failure", "found", _feedback(note))
    if not notes:
        yield junit.Case(FILES, "what is written")


def _case(case: ProofCase) -> junit.Case:
    if case.notes:
        kind, told = "failure", _feedback(case.notes[0])
    elif case.skipped is not None:
        kind, told = "skipped", Feedback(Cleaner().prose(case.skipped))
    else:
        return junit.Case(case.exercise, case.name, seconds=case.seconds)
    return junit.Case(case.exercise, case.name, kind, kind, told, case.seconds)


def _feedback(note: Note) -> Feedback:
    clean = Cleaner()
    step = clean.prose(note.next_step) if note.next_step else None
    return Feedback(clean.prose(note.what), where=(Location(note.file, note.line),), advice=step)

"""GitHub's job summary: a table of everyone, then what did not pass. At most 1 MiB is shown of it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from course.report.gradebook.letter import section
from course.report.gradebook.markup import plain
from course.report.gradebook.model import GradedExercise
from course.report.gradebook.sheets import Mark, Sheet
from course.report.gradebook.words import score

LIMIT = 1024 * 1024
# Kept free for the note that says what was left out.
_NOTE_ROOM = 200


def job_summary(
    course: str, exercises: Iterable[GradedExercise], sheets: Iterable[Sheet], *, used: int = 0
) -> str:
    """The Markdown to append to the summary's file; empty when that is full.

    course, exercises: cleaned, like the sheets. used: bytes that stand in the file already. What does
    not fit is left out from the end, in whole rows and whole exercises, and a note counts it.
    """
    room = LIMIT - used - _NOTE_ROOM
    if room < 0:
        return ""
    table, details = _Page(room), _Page(room)
    titles = ["id", "name", *(plain(exercise.id) for exercise in exercises), "total"]
    table.add(f"# {plain(course)}\n\n{_row(titles)}{_row(['---'] * len(titles))}")
    for sheet in sheets:
        table.add(_row(_cells(sheet)))
        for section_of_one in _details(sheet):
            details.add(section_of_one)
    details.shrink(table.room)
    return "".join((*table.pieces, *details.pieces, _note(table.left_out, details.left_out)))


class _Page:
    """Pieces of text in `room` bytes; after the first that does not fit, no other is taken."""

    def __init__(self, room: int) -> None:
        self.pieces: list[str] = []
        self.room = room
        self.left_out = 0

    def add(self, piece: str) -> None:
        size = _size(piece)
        if self.left_out or size > self.room:
            self.left_out += 1
        else:
            self.pieces.append(piece)
            self.room -= size

    def shrink(self, room: int) -> None:
        """Leave out the last pieces until the others fit."""
        taken = sum(map(_size, self.pieces))
        while taken > room:
            taken -= _size(self.pieces.pop())
            self.left_out += 1


def _size(text: str) -> int:
    return len(text.encode("utf-8"))


def _note(rows: int, exercises: int) -> str:
    if not rows and not exercises:
        return ""
    missing = " and ".join(
        [f"{rows} rows of the table"] * bool(rows) + [f"details of {exercises} exercises"] * bool(exercises)
    )
    return f"\n\nGitHub shows at most 1 MiB. Left out here: {missing}. They are in results.json.\n"


def _cells(sheet: Sheet) -> Iterator[str]:
    yield from (plain(sheet.person.id), plain(sheet.person.name))
    yield from map(_verdict, sheet.marks)
    yield sheet.state if sheet.points is None else score(sheet.points, sheet.max_points)


def _verdict(mark: Mark) -> str:
    return f"{mark.verdict}, {score(mark.points, mark.max_points)}" if mark.counts else mark.verdict


def _details(sheet: Sheet) -> Iterator[str]:
    """What did not pass, an exercise at a time; the person's name stands above the first."""
    heading = f"\n## {plain(sheet.person.name or sheet.person.id)}\n"
    for mark in sheet.marks:
        if mark.verdict != "passed":
            yield "\n".join((heading, "\n\n".join(section(mark, "###")), ""))
            heading = ""


def _row(cells: Iterable[str]) -> str:
    return f"| {' | '.join(cells)} |\n"

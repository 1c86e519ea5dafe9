"""results.csv: the gradebook as a table, a row for each person.

It is opened in spreadsheets, which run what looks like a formula; so a text that could be one gets an
apostrophe in front, as a person would type it. Excel takes UTF-8 for the local alphabet unless a byte
order mark comes first, and an instructor who saves the file again has lost the names; so there is one.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Iterator

from course.report.console import number
from course.report.gradebook.model import GradedExercise
from course.report.gradebook.sheets import Mark, Sheet

BYTE_ORDER_MARK = "\ufeff"
ENDS = ("total", "total max", "state", "remarks")
# Also after a semicolon, at which spreadsheets of many countries split a line; and in full width, which
# East Asian ones take as well.
_FORMULA = re.compile(r"(^|[;\t\r\n])(\s*)(?=[=+\-@\uff1d\uff0b\uff0d\uff20])")


def rows(exercises: Iterable[GradedExercise], sheets: Iterable[Sheet]) -> Iterator[str]:
    """The file line by line, byte order mark and line ends (CR LF) included."""
    kinds = ("points", "max", "verdict")
    columns = (f"{exercise.id} {kind}" for exercise in exercises for kind in kinds)
    yield BYTE_ORDER_MARK + _row(("id", "name", *columns, *ENDS))
    for sheet in sheets:
        yield _row(_cells(sheet))


def guarded(text: str) -> str:
    """`text`, so that no spreadsheet takes it for a formula."""
    return _FORMULA.sub(r"\1\2'", text)


def _cells(sheet: Sheet) -> Iterator[str]:
    yield from (sheet.person.id, sheet.person.name)
    for mark in sheet.marks:
        yield from _mark(mark)
    yield from (_number(sheet.points), _number(sheet.max_points), sheet.state, " ".join(sheet.remarks))


def _mark(mark: Mark) -> Iterator[str]:
    yield from (_number(mark.points), _number(mark.max_points), mark.verdict)


def _number(value: float | None) -> str:
    return "" if value is None else number(value)


def _row(cells: Iterable[str]) -> str:
    line = io.StringIO()
    csv.writer(line, lineterminator="\r\n").writerow([guarded(cell) for cell in cells])
    return line.getvalue()

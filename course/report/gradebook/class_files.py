"""All reports of a class in one folder; the contents of results.csv and results.json."""

from __future__ import annotations

import csv
import hashlib
import io
import json
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import asdict
from itertools import starmap
from pathlib import Path
from typing import Any

from msgspec import to_builtins

from course.files import write_pieces
from course.model.gradebook import Delay, Gradebook, GradedExercise, Person
from course.model.result import CheckResult
from course.report.console import number
from course.report.gradebook import gradescope, junit
from course.report.gradebook.check_words import comments, score
from course.report.gradebook.cleaning import NAME_LIMIT, Cleaner
from course.report.gradebook.letter import letter
from course.report.gradebook.sheets import Mark, Names, Sheet, exercises_of, file_stem, sheets, tidy

_WRITTEN = "letters.json"  # digests of what was written for each person
BYTE_ORDER_MARK = "\ufeff"
ENDS = ("total", "total max", "raw total", "late", "state", "comments", "remarks")
# Also after a semicolon, where spreadsheets split lines in many countries, and with the full-width
# characters that East Asian spreadsheets accept, too.
_FORMULA = re.compile(r"(^|[;\t\r\n])(\s*)(?=[=+\-@\uff1d\uff0b\uff0d\uff20])")


def rows(exercises: Iterable[GradedExercise], sheets: Iterable[Sheet]) -> Iterator[str]:
    """The file line by line, byte order mark and line ends (CR LF) included."""
    kinds = ("points", "max", "verdict")
    columns = (f"{exercise.id} {kind}" for exercise in exercises for kind in kinds)
    yield BYTE_ORDER_MARK + _row(("id", "name", *columns, *ENDS))
    for sheet in sheets:
        yield _row(_cells(sheet))


def guarded(text: str) -> str:
    """`text`, changed so that no spreadsheet takes it for a formula."""
    return _FORMULA.sub(r"\1\2'", text)


def _cells(sheet: Sheet) -> Iterator[str]:
    yield from (sheet.person.id, sheet.person.name)
    for mark in sheet.marks:
        yield from _mark_cells(mark)
    raw = None if sheet.points is None else sheet.raw_points
    yield from (_number(sheet.points), _number(sheet.max_points), _number(raw), sheet.late, sheet.state)
    yield from (" ".join(comments(sheet)), " ".join(sheet.remarks))


def _mark_cells(mark: Mark) -> Iterator[str]:
    yield from (_number(mark.points), _number(mark.max_points), mark.verdict)


def _number(value: float | None) -> str:
    return "" if value is None else number(value)


def _row(cells: Iterable[str]) -> str:
    line = io.StringIO()
    csv.writer(line, lineterminator="\r\n").writerow([guarded(cell) for cell in cells])
    return line.getvalue()


VERSION = 1


def pieces(gradebook: Gradebook, cleaner: Cleaner, sheets: Iterable[Sheet]) -> Iterator[str]:
    """The JSON document, one submission at a time."""
    head = {
        "schema": VERSION,
        "course": cleaner.prose(gradebook.course),
        "began": gradebook.began.isoformat(timespec="seconds"),
        "ended": gradebook.ended.isoformat(timespec="seconds"),
        "containment": cleaner.line(gradebook.containment, NAME_LIMIT),
        "exercises": [asdict(exercise) for exercise in exercises_of(gradebook, cleaner)],
    }
    yield f'{_json(head, indent=2).removesuffix("}").rstrip()},\n  "graded": ['
    separator = "\n"
    for sheet in sheets:
        yield f"{separator}    {_json(as_data(sheet))}"
        separator = ",\n"
    yield "\n  ]\n}\n"


def as_data(sheet: Sheet) -> dict[str, Any]:
    """One submission as JSON types."""
    return {
        "id": sheet.person.id,
        "name": sheet.person.name,
        "source": sheet.source,
        "state": sheet.state,
        "points": sheet.points,
        "max_points": sheet.max_points,
        "raw_points": None if sheet.points is None else sheet.raw_points,
        "late": _late(sheet.lateness),
        "by_hand": [asdict(each) for each in sheet.by_hand],
        "remarks": list(sheet.remarks),
        "results": [_mark(mark) for mark in sheet.marks],
    }


def _late(lateness: Delay | None) -> dict[str, Any] | None:
    if lateness is None:
        return None
    at = lateness.handed_in
    return {
        "handed_in": at.isoformat(timespec="seconds") if at else None,
        "seconds": round(lateness.seconds),
        "penalty": lateness.penalty,
        "words": lateness.words,
    }


def _mark(mark: Mark) -> dict[str, Any]:
    return {
        "exercise": mark.exercise.id,
        "verdict": mark.verdict,
        "points": mark.points,
        "max_points": mark.max_points,
        "raw_points": mark.raw_points,
        "by_hand": [asdict(each) for each in mark.by_hand],
        "seconds": round(mark.seconds, 3),
        "checks": [_check(check) for check in mark.result.checks] if mark.result else [],
        "notes": list(mark.result.notes) if mark.result else [],
    }


def _check(check: CheckResult) -> dict[str, Any]:
    return {
        "id": check.id,
        "title": check.title,
        "outcome": check.outcome.value,
        "points": tidy(check.earned),
        "max_points": tidy(check.points),
        "bonus": check.bonus,
        "skipped_because": check.skipped_because,
        "feedback": to_builtins(check.feedback),
    }


def _json(data: object, indent: int | None = None) -> str:
    """JSON that is safe inside a script element: without `<`."""
    return json.dumps(data, ensure_ascii=False, allow_nan=False, indent=indent).replace("<", "\\u003c")


def write_reports(folder: Path, gradebook: Gradebook, cleaner: Cleaner) -> None:
    """results.csv, results.json, junit.xml, and for each person feedback/NAME.md and gradescope/NAME.json.

    Only one submission is in memory at a time; the gradebook is read five times. Raises StorageError.
    """
    course = cleaner.prose(gradebook.course)

    def walk() -> Iterator[Sheet]:
        return sheets(gradebook, cleaner)

    write_pieces(folder / "results.csv", rows(exercises_of(gradebook, cleaner), walk()))
    write_pieces(folder / "results.json", pieces(gradebook, cleaner, walk()))
    write_pieces(folder / "junit.xml", junit.pieces(course, gradebook.began, walk))
    names = Names()
    written = {}
    for sheet in walk():
        name = names.unique(file_stem(sheet.person.id))
        texts = {
            f"feedback/{name}.md": letter(sheet, course),
            f"gradescope/{name}.json": gradescope.as_text(sheet),
        }
        for file, text in texts.items():
            write_pieces(folder / file, [text])
            written[file] = _digest(text.encode())
    _forget_others(folder, written)


def _forget_others(folder: Path, written: dict[str, str]) -> None:
    """Remove files of people who are no longer in the class, unless somebody has edited them."""
    listed = folder / _WRITTEN
    try:
        before = json.loads(listed.read_bytes()) if listed.is_file() else {}
    except ValueError:
        before = {}
    for name, digest in before.items() if isinstance(before, dict) else ():
        file = folder / str(name)
        ours = file.parent.parent == folder and file.parent.name in ("feedback", "gradescope")
        if ours and name not in written and file.is_file() and _digest(file.read_bytes()) == digest:
            file.unlink()
    write_pieces(listed, [json.dumps(written)])


def _digest(data: bytes) -> str:
    return hashlib.blake2b(data, digest_size=16).hexdigest()


_MARKS_HEAD = """\
# Marks by hand, on top of the machine's results. Empty fields change nothing.
# An entry counts for everyone in its list. People with the same code and results share one.
#   points   instead of the machine's      bonus    added; below zero is subtracted
#   comment  for the learner               rubric   ids of items below
#   check    the id of one check           excused  true: it does not count
#   late     no, or by how much (2 days)
rubric:
  # tidy: {bonus: 0.5, comment: Easy to read.}
marks:
"""


def marks_to_review(sheets: Iterable[Sheet], code_of: Callable[[int, str], str]) -> Iterator[str]:
    """A marks.yaml to fill in: everybody, with each exercise that did not earn all of its points.

    code_of: from a place in the class and an exercise to a text, equal for equal code; "" if not known.
    """
    entries: dict[object, tuple[Mark, list[Person]]] = {}
    for place, sheet in enumerate(sheets):
        for mark in sheet.marks:
            if mark.points is None or mark.points < mark.exercise.max_points:
                code = code_of(place, mark.exercise.id)
                checks = tuple((one.id, one.outcome) for one in (mark.result.checks if mark.result else ()))
                alike = (mark.exercise.id, mark.verdict, mark.points, checks, code or place)
                entries.setdefault(alike, (mark, []))[1].append(sheet.person)
    yield _MARKS_HEAD
    yield from starmap(_to_review, entries.values())


def _to_review(mark: Mark, people: Sequence[Person]) -> str:
    # A JSON string is also a YAML string, whatever it contains; a comment ends at the end of its line.
    texts = [[json.dumps(text, ensure_ascii=False) for text in (one.id, one.name)] for one in people]
    one = f" {texts[0][0]}  # {texts[0][1]}\n"
    several = "\n" + "".join(f"      - {who}  # {name}\n" for who, name in texts)
    return (
        f"  - person:{several if len(texts) > 1 else one}"
        f"    exercise: {mark.exercise.id}  # {mark.verdict}, {score(mark.points, mark.max_points)}\n"
        "    points:\n    bonus:\n    comment:\n"
    )

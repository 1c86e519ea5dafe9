"""A roster: a CSV file that maps people to what they handed in."""

from __future__ import annotations

import codecs
import csv
from pathlib import Path

from course.batch.intake.model import Part, Person, Source
from course.batch.intake.people import person
from course.errors import UsageError
from course.home.opening import Finding, visible
from course.home.storage import storing

_LARGEST = 50_000_000  # bytes
_DELIMITERS = (",", ";", "\t", "|")
_FORM = "its first line names the columns: id, name, path (name may be missing)"


def read_roster(file: Path) -> tuple[tuple[Source, ...], tuple[Finding, ...]]:
    """One source for each person, in the file's order; findings about lines that are nobody's.

    Relative paths count from the file's folder. Lines of the same id belong together.
    Raises UsageError for a file that is no roster.
    """
    people: dict[str, Source] = {}
    findings = []
    for number, row in _rows(file):
        if not row.get("id"):
            findings.append(Finding("A line of the roster has no id.", "Give it one.", f"line {number}"))
            continue
        source = _source(row, file.parent, f"line {number}")
        before = people.get(source.person.id)
        people[source.person.id] = _together(before, source) if before else source
    return tuple(people.values()), tuple(findings)


def _rows(file: Path) -> list[tuple[int, dict[str, str]]]:
    lines = _text(file).splitlines(keepends=True)
    for delimiter in _DELIMITERS:
        reader = csv.reader(lines, delimiter=delimiter, skipinitialspace=True)
        try:
            head = [name.strip().lower() for name in next(reader, [])]
            if {"id", "path"} <= set(head):
                return [
                    (reader.line_num, dict(zip(head, (cell.strip() for cell in row), strict=False)))
                    for row in reader
                    if any(cell.strip() for cell in row)
                ]
        except csv.Error as error:
            raise UsageError(f"{visible(file.name)} is no roster: {error}", _FORM) from None
    raise UsageError(f"{visible(file.name)} is no roster: it lacks the columns id and path", _FORM)


def _text(file: Path) -> str:
    """In UTF-8, or as Excel writes: UTF-16 with a mark, or Windows' own letters."""
    with storing(f"{file.name} cannot be read"):
        if file.stat().st_size > _LARGEST:
            raise UsageError(f"{visible(file.name)} is too large for a roster", _FORM)
        data = file.read_bytes()
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return data.decode("utf-16", errors="replace")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("cp1252", errors="replace")


def _source(row: dict[str, str], folder: Path, where: str) -> Source:
    who = person(row["id"], row.get("name") or row["id"])
    given = row.get("path", "")
    path = folder / given
    if not given:
        missing = Finding("The roster names no path for this person.", "Nothing was handed in?", where)
    elif "\0" in given or not path.exists():
        missing = Finding("There is nothing at the path that the roster names.", "Correct the path.", where)
    else:
        return Source(who, visible(given), (Part(path.name, path),))
    return Source(who, visible(given), (), (missing,))


def _together(one: Source, other: Source) -> Source:
    findings = one.findings + other.findings
    if _name(one.person) != _name(other.person):
        what = f"The roster gives this id to {one.person.name} and to {other.person.name}."
        findings += (Finding(what, "Give each person an id of their own."),)
    shown = f"{one.shown}, {other.shown}"
    return Source(one.person, shown, one.parts + other.parts, findings)


def _name(who: Person) -> str:
    return who.name.casefold()

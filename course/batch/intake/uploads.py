"""Finds the submissions in what the instructor names: a folder, an archive of a class, or a CSV roster."""

from __future__ import annotations

import codecs
import csv
import os
from collections.abc import Iterable
from pathlib import Path

from course.batch.intake.people import grouped, labels, moment, person
from course.batch.intake.submission import Part, Upload, Uploads
from course.batch.intake.tree import ONE, RESULTS_LEFT_OUT, holds_only_results
from course.errors import UsageError
from course.home.opening import (
    USUAL,
    Limits,
    Notes,
    Opened,
    Refused,
    Remark,
    archive_stem,
    is_archive,
    open_parts,
    visible,
    zip_names,
)
from course.home.opening.unpack import LINK_OUT
from course.home.storage import storing
from course.model import replace
from course.model.gradebook import Person

_LARGEST = 50_000_000  # bytes
_DELIMITERS = (",", ";", "\t", "|")
_FORM = "its first line names the columns: id, name, path (name may be missing)"


def read_roster(file: Path) -> tuple[tuple[Upload, ...], tuple[Remark, ...]]:
    """One upload for each person, in the file's order, and findings about lines that are nobody's.

    Paths may be relative to the file's folder. Lines with the same id belong together.
    Raises UsageError for a file that is not a roster.
    """
    people: dict[str, Upload] = {}
    findings = []
    for number, row in _rows(file, "a roster", _FORM, {"id", "path"}):
        if not row.get("id"):
            findings.append(Remark("A line of the roster has no id.", "Give it one.", f"line {number}"))
            continue
        source = _source(row, file.parent, f"line {number}")
        before = people.get(source.person.id)
        people[source.person.id] = _together(before, source) if before else source
    return tuple(people.values()), tuple(findings)


def read_table(file: Path, kind: str, form: str) -> list[dict[str, str]]:
    """The rows of a file with at least two columns. Each is a dict by column name, in lowercase.

    Raises UsageError for a file that is not a table. kind: what it should be. form: how to write one.
    """
    return [row for _, row in _rows(file, kind, form, set())]


def _rows(file: Path, kind: str, form: str, needed: set[str]) -> list[tuple[int, dict[str, str]]]:
    lines = _text(file, kind, form).splitlines(keepends=True)
    for delimiter in _DELIMITERS:
        reader = csv.reader(lines, delimiter=delimiter, skipinitialspace=True)
        try:
            head = [name.strip().lower() for name in next(reader, [])]
            if needed <= set(head) and len(head) > 1:
                return [
                    (reader.line_num, dict(zip(head, (cell.strip() for cell in row), strict=False)))
                    for row in reader
                    if any(cell.strip() for cell in row)
                ]
        except csv.Error as error:
            raise UsageError(f"{visible(file.name)} is not {kind}: {error}", form) from None
    lack = f"lacks the columns {' and '.join(sorted(needed))}" if needed else "has no line of column names"
    raise UsageError(f"{visible(file.name)} is not {kind}: it {lack}", form)


def _text(file: Path, kind: str, form: str) -> str:
    """Decode UTF-8, or what Excel writes: UTF-16 with a mark, or a Windows code page."""
    with storing(f"{file.name} cannot be read"):
        if file.stat().st_size > _LARGEST:
            raise UsageError(f"{visible(file.name)} is too large for {kind}", form)
        data = file.read_bytes()
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return data.decode("utf-16", errors="replace")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("cp1252", errors="replace")


def _source(row: dict[str, str], folder: Path, where: str) -> Upload:
    who = replace(
        person(row["id"], row.get("name") or row["id"]),
        group=row.get("group", ""),
        handed_in=moment(row.get("submitted", "")),
    )
    given = row.get("path", "")
    path = folder / given
    if "\\" in given and "\0" not in given and not _is_there(path):  # written on Windows
        path = folder / given.replace("\\", "/")
    if not given:
        missing = Remark("The roster gives no path for this person.", "Was nothing handed in?", where)
    elif "\0" in given or not _is_there(path):
        missing = Remark("There is nothing at the path that the roster gives.", "Correct the path.", where)
    else:
        return Upload(who, visible(given), (Part(path.name, path),))
    return Upload(who, visible(given), (), (missing,))


def _is_there(path: Path) -> bool:
    try:
        return path.exists()
    except OSError:  # the name is too long, or the folder may not be read
        return False


def _together(one: Upload, other: Upload) -> Upload:
    findings = one.findings + other.findings
    if _name(one.person) != _name(other.person):
        what = f"The roster gives this id to {one.person.name} and to {other.person.name}."
        findings += (Remark(what, "Give each person a different id."),)
    shown = f"{one.shown}, {other.shown}"
    return Upload(one.person, shown, one.parts + other.parts, findings)


def _name(who: Person) -> str:
    return who.name.casefold()


_PASSED_OVER = frozenset({"__MACOSX", "Thumbs.db", "desktop.ini"})


def find_sources(submissions: Path, opened: Path, limits: Limits = USUAL) -> Uploads:
    """Who handed in what. Folders of results do not count.

    A class's zip is opened into the folder `opened`, each person's part separately, and replaces what an
    earlier call left there. Raises UsageError if `submissions` is not a class, StorageError for the disk.
    """
    if submissions.is_dir():
        found = _folder(submissions)
    elif submissions.is_file() and submissions.suffix.lower() in (".csv", ".tsv"):
        found = Uploads(*read_roster(submissions))
    elif submissions.is_file() and is_archive(submissions.name):
        found = _archive(submissions, opened, limits)
    else:
        what = "there is no" if not submissions.exists() else "not a folder, archive, or CSV roster:"
        raise UsageError(f"{what} {visible(str(submissions))}", "name a folder, a zip, or a CSV roster")
    if not found.each:
        raise UsageError(
            f"no submission is in {visible(str(submissions))}", "name the folder that contains them"
        )
    return replace(found, each=tuple(sorted(found.each, key=_by_name)))


def one_source(submission: Path) -> Uploads:
    """A folder or an archive that is one submission, whatever it looks like. Raises UsageError."""
    if not submission.exists():
        raise UsageError(f"there is no {visible(str(submission))}", "name a folder or an archive")
    name = submission.resolve().name
    return Uploads((_single(submission, name if submission.is_dir() else archive_stem(name)),))


def _by_name(source: Upload) -> tuple[str, str]:
    return source.person.name.casefold(), source.person.id


def _folder(folder: Path) -> Uploads:
    with storing(f"{folder} cannot be read"):
        alone = any(os.path.lexists(folder / name) for name in ONE)
        paths = sorted(entries_of(folder))
        notes = Notes()
        for path in sorted(_results_in(folder)):
            notes.add(RESULTS_LEFT_OUT, path.name)
    name = folder.resolve().name
    if alone:
        return Uploads((_single(folder, name),))
    found = grouped([_opened(path) for path in paths], name)
    return replace(found, findings=(*found.findings, *notes.findings()))


def entries_of(folder: Path) -> list[Path]:
    """The entries of a folder that count as handed in, without results of any run. Raises OSError."""
    results = _results_in(folder)
    return [path for path in folder.iterdir() if _counts(path.name) and path not in results]


def _results_in(folder: Path) -> set[Path]:
    """Folders of results, except with a name from an LMS: people in its export always have a row."""
    told = labels(path.name for path in folder.iterdir())
    return {folder / name for name in told if not told[name].is_lms and holds_only_results(folder / name)}


def _opened(path: Path) -> Opened:
    """An entry of a class's folder. It has no path if its link leads to an unreadable place."""
    try:
        path.is_dir()
    except OSError:  # the name is too long, or the folder may not be read
        return Opened(path.name, None, (Remark(LINK_OUT, where=visible(path.name)),))
    return Opened(path.name, path, ())


def _archive(archive: Path, opened: Path, limits: Limits) -> Uploads:
    """A zip may contain a whole class; a tar belongs to one person."""
    stem = archive_stem(archive.name)
    try:
        below = _wrapper(zip_names(archive, limits))
    except Refused:
        below = None  # `look` will say what is wrong with it
    if below is None:
        return Uploads((_single(archive, stem),))
    every = open_parts(archive, opened, below, limits)
    found = grouped([part for part in every if _counts(part.name)], below or stem)
    nobodys = tuple(finding for part in every if not part.name for finding in part.findings)
    return Uploads(found.each, found.findings + nobodys)


def _wrapper(names: Iterable[str]) -> str | None:
    """The folder in a zip that contains the submissions, "" for the zip itself; None for one submission."""
    paths = [name.split("/") for name in names]
    tops = {path[0] for path in paths}
    if ONE & tops:
        return None
    counting = [top for top in tops if _counts(top)]
    inside = {path[1] for path in paths if path[0] in counting and len(path) > 1}
    if len(counting) != 1 or not inside or labels(counting)[counting[0]].is_lms:
        return ""
    return None if ONE & inside else counting[0]


def _counts(name: str) -> bool:
    return bool(name) and not name.startswith(".") and name not in _PASSED_OVER


def _single(path: Path, name: str) -> Upload:
    return Upload(person(name, name), visible(path.name or name), (Part(path.name or name, path),))

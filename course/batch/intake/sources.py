"""Finds the submissions in what the instructor names: a folder, an archive of a class, or a roster."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from course.batch.intake.grouping import grouped
from course.batch.intake.model import Part, Source, Sources
from course.batch.intake.people import labels, person
from course.batch.intake.roster import read_roster
from course.content.layout import WORKSPACE
from course.errors import UsageError
from course.home.opening import (
    USUAL,
    Limits,
    Opened,
    Refused,
    archive_stem,
    is_archive,
    open_parts,
    visible,
    zip_names,
)
from course.home.storage import storing

_ONE = frozenset({WORKSPACE, ".ros2course", "src", "package.xml"})
_PASSED_OVER = frozenset({"__MACOSX", "Thumbs.db", "desktop.ini"})


def find_sources(submissions: Path, opened: Path, limits: Limits = USUAL) -> Sources:
    """Who handed in what. A class's zip is opened into the folder `opened`, each person's part by itself;
    what an earlier call left there is replaced.

    Raises UsageError when `submissions` is nothing of the kind, and StorageError for the disk.
    """
    if submissions.is_dir():
        found = _folder(submissions)
    elif submissions.is_file() and submissions.suffix.lower() in (".csv", ".tsv"):
        found = Sources(*read_roster(submissions))
    elif submissions.is_file() and is_archive(submissions.name):
        found = _archive(submissions, opened, limits)
    else:
        what = "there is no" if not submissions.exists() else "that is no folder, archive or CSV roster:"
        raise UsageError(f"{what} {visible(str(submissions))}", "name a folder, a zip or a CSV roster")
    if not found.each:
        raise UsageError(
            f"no submission is in {visible(str(submissions))}", "name the folder that holds them"
        )
    return replace(found, each=tuple(sorted(found.each, key=_by_name)))


def one_source(submission: Path) -> Sources:
    """A folder or an archive that is one submission, whatever it looks like. Raises UsageError."""
    if not submission.exists():
        raise UsageError(f"there is no {visible(str(submission))}", "name a folder or an archive")
    name = submission.resolve().name
    return Sources((_single(submission, name if submission.is_dir() else archive_stem(name)),))


def _by_name(source: Source) -> tuple[str, str]:
    return source.person.name.casefold(), source.person.id


def _folder(folder: Path) -> Sources:
    with storing(f"{folder} cannot be read"):
        paths = sorted(folder.iterdir())
    name = folder.resolve().name
    if _ONE & {path.name for path in paths}:
        return Sources((_single(folder, name),))
    return grouped([Opened(path.name, path, ()) for path in paths if _counts(path.name)], name)


def _archive(archive: Path, opened: Path, limits: Limits) -> Sources:
    """A zip may be a class's; a tar is one person's."""
    stem = archive_stem(archive.name)
    try:
        below = _wrapper(zip_names(archive, limits))
    except Refused:
        below = None  # `look` will say what is wrong with it
    if below is None:
        return Sources((_single(archive, stem),))
    every = open_parts(archive, opened, below, limits)
    found = grouped([part for part in every if _counts(part.name)], below or stem)
    nobodys = tuple(finding for part in every if not part.name for finding in part.findings)
    return Sources(found.each, found.findings + nobodys)


def _wrapper(names: Iterable[str]) -> str | None:
    """The folder of a zip that holds the submissions, "" for the zip itself; None for a single submission."""
    paths = [name.split("/") for name in names]
    tops = {path[0] for path in paths}
    if _ONE & tops:
        return None
    counting = [top for top in tops if _counts(top)]
    inside = {path[1] for path in paths if path[0] in counting and len(path) > 1}
    if len(counting) != 1 or not inside or labels(counting)[counting[0]].is_lms:
        return ""
    return None if _ONE & inside else counting[0]


def _counts(name: str) -> bool:
    return bool(name) and not name.startswith(".") and name not in _PASSED_OVER


def _single(path: Path, name: str) -> Source:
    return Source(person(name, name), visible(path.name or name), (Part(path.name or name, path),))

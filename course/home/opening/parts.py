"""Opens a «download all» zip: each person's part by itself, so that one that is refused harms no other."""

from __future__ import annotations

import shutil
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from course.home.opening.finding import Finding, Notes, Refused
from course.home.opening.limits import USUAL, Limits, Meter
from course.home.opening.member import Member
from course.home.opening.names import Unsafe, safe_path
from course.home.opening.unpack import unpack
from course.home.opening.zips import zip_members
from course.home.storage import storing

_PEOPLE = 10  # times the files of one submission, at the most


@dataclass(frozen=True)
class Opened:
    """One entry of the archive, at `path` (a file or a folder); None when it was refused.

    The last one may have no name: it tells of what was nobody's.
    """

    name: str
    path: Path | None
    findings: tuple[Finding, ...]


def zip_names(archive: Path, limits: Limits = USUAL) -> tuple[str, ...]:
    """The safe ones among the names in a zip. Raises Refused."""
    with storing(f"{archive.name} cannot be read"), zip_members(archive, _of_class(limits)) as members:
        return tuple(path for member in members if (path := _path(member)))


def open_parts(archive: Path, folder: Path, below: str = "", limits: Limits = USUAL) -> tuple[Opened, ...]:
    """Open each entry of the zip (of its folder `below`) into a folder of its own in `folder`.

    `limits` hold for each; what an earlier call left is replaced. Raises Refused when the zip as a
    whole cannot be read, and StorageError when the disk does not take it.
    """
    with storing(f"{archive.name} cannot be opened"), zip_members(archive, _of_class(limits)) as members:
        parts = _by_name(members, f"{below}/" if below else "")
        unsafe = tuple(member.name for member in members if not _path(member) and member.name.strip("./"))
        opened = (_open(own, parts[own], folder / str(n), limits) for n, own in enumerate(parts))
        return (*opened, *_left_out(unsafe))


def _of_class(limits: Limits) -> Limits:
    return replace(limits, files=_PEOPLE * limits.files)


def _by_name(members: Iterable[Member], prefix: str) -> dict[str, list[Member]]:
    parts: dict[str, list[Member]] = {}
    for member in members:
        path = _path(member)
        if path.startswith(prefix) and path != prefix:
            own = path.removeprefix(prefix)
            parts.setdefault(own.split("/")[0], []).append(replace(member, name=own))
    return parts


def _path(member: Member) -> str:
    try:
        return safe_path(member.name)
    except Unsafe:
        return ""


def _left_out(names: tuple[str, ...]) -> Iterator[Opened]:
    notes = Notes()
    for name in names:
        notes.add("Entries whose names lead out of the archive were left out.", name)
    if names:
        yield Opened("", None, notes.findings())


def _open(name: str, members: list[Member], folder: Path, limits: Limits) -> Opened:
    shutil.rmtree(folder, ignore_errors=True)
    meter = Meter(limits, sum(member.packed for member in members))
    try:
        return Opened(name, folder / name, unpack(members, folder, meter))
    except Refused as error:
        return Opened(name, None, (error.finding,))

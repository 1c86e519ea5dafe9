"""Opens archives into new folders: files first, links last, all or nothing.

A "download all" zip is opened part by part, so that a refused part does not affect the others.
"""

from __future__ import annotations

import contextlib
import os
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import IO

from course.files import new_folder, wipe
from course.home.opening.findings import (
    BROKEN_UPLOAD,
    LONGEST_PATH,
    USUAL,
    Limits,
    Meter,
    Notes,
    Refused,
    Remark,
    Unsafe,
    reading,
    safe_path,
)
from course.home.opening.formats import OPENERS, Member, tar_members, zip_members
from course.home.storage import storing
from course.model import replace

_STEP = 1 << 16

RENAMED = "Unprintable characters in names were replaced with `_`."
TWICE = "The archive contains more than one file with this name; the last one was used."
BOTH = "A file and a folder have the same name; the later one was left out."
LINK_OUT = "Links that lead outside the submission or nowhere were left out."
NO_FILE = "It is not an ordinary file, but a device, a pipe, or a sparse file; it was left out."


def unpack(members: Iterable[Member], folder: Path, meter: Meter) -> tuple[Remark, ...]:
    """Make `folder` from the members; returns what was left out or changed.

    Raises Refused if there is too much or it is broken. Raises OSError if it cannot be written, or if
    `folder` exists and is not empty. Then nothing new is left behind.
    """
    with new_folder(folder) as part:
        unpacking = _Unpacking(Path(os.path.realpath(part)), meter)
        for member in members:
            unpacking.take(member)
        unpacking.make_links()
    return unpacking.notes.findings()


class _Unpacking:
    def __init__(self, top: Path, meter: Meter) -> None:
        self.notes = Notes()
        self._top = top
        self._meter = meter
        self._links: dict[str, str] = {}

    def take(self, member: Member) -> None:
        self._meter.entry()
        try:
            path = safe_path(member.name)
        except Unsafe as error:
            self.notes.add(f"Entries with {error} were left out.", member.name)
            return
        if path:
            self._note_name(member, path)
            with self._in_one_role(member.name):
                self._make(member, path)

    def _note_name(self, member: Member, path: str) -> None:
        if path != str(PurePosixPath(member.name)):
            self.notes.add(RENAMED, member.name)

    @contextlib.contextmanager
    def _in_one_role(self, name: str) -> Iterator[None]:
        try:
            yield
        except (NotADirectoryError, IsADirectoryError, FileExistsError):
            self.notes.add(BOTH, name)

    def _make(self, member: Member, path: str) -> None:
        target = self._top / path
        if member.kind == "folder":
            target.mkdir(parents=True, exist_ok=True)
        elif member.kind == "file":
            with _opened(member) as content:
                self._write(target, content, member)
        elif member.kind == "hard link":
            self._copy(member, target)
        elif member.kind == "link":
            self._links[path] = member.target
        else:
            self.notes.add(NO_FILE, member.name)

    def _copy(self, member: Member, target: Path) -> None:
        """Copy the target of a hard link. No link that leads outside has been made yet."""
        try:
            source = self._top / safe_path(member.target)
        except Unsafe:
            source = self._top
        if not source.is_file() or source == target:
            self.notes.add(LINK_OUT, member.name)
            return
        with source.open("rb") as content:
            self._write(target, content, member)

    def _write(self, target: Path, content: IO[bytes], member: Member) -> None:
        target.parent.mkdir(parents=True, exist_ok=True)
        if target.exists():
            target.unlink()  # raises for a folder
            self.notes.add(TWICE, member.name)
        with target.open("xb") as out:
            size = 0
            while data := _some(content):
                size += len(data)
                self._meter.data(len(data), size, member.name)
                out.write(data)
        target.chmod(0o755 if member.executable else 0o644)

    def make_links(self) -> None:
        """Make the links that stay inside, after all files, so that nothing was written through a link."""
        for path, target in self._links.items():
            with self._in_one_role(path):
                self._link(self._top / path, target)
        for path in self._links:
            link = self._top / path
            if link.is_symlink() and not self._stays_inside(link):
                link.unlink()
                self.notes.add(LINK_OUT, path)

    def _link(self, link: Path, target: str) -> None:
        through_a_link = os.path.realpath(link.parent) != str(link.parent)
        if through_a_link or target.startswith("/") or "\0" in target or not 0 < len(target) <= LONGEST_PATH:
            self.notes.add(LINK_OUT, str(link.relative_to(self._top)))
            return
        link.parent.mkdir(parents=True, exist_ok=True)
        link.symlink_to(target)

    def _stays_inside(self, link: Path) -> bool:
        return leads_inside(link, self._top) and not Path(os.path.realpath(link)).is_symlink()


def leads_inside(link: Path, top: Path) -> bool:
    """Whether the link leads to something that exists inside `top`, a folder without links in its path."""
    real = Path(os.path.realpath(link))
    try:
        return real.is_relative_to(top) and real.exists()
    except OSError:  # a name that is too long to exist
        return False


@contextlib.contextmanager
def _opened(member: Member) -> Iterator[IO[bytes]]:
    with reading():
        content = member.open()
    with content as stream:
        yield stream


def _some(content: IO[bytes]) -> bytes:
    with reading():
        return content.read(_STEP)


_ENDINGS = re.compile(r"\.(zip|tar|tgz|tbz2?|txz|tar\.(gz|bz2|xz))$", re.IGNORECASE)
_NOT_OPENED = re.compile(r"\.(rar|7z|tar\.zst|tar\.lzma|cab|iso|dmg|gz|xz|bz2)$", re.IGNORECASE)


def is_archive(name: str) -> bool:
    """Whether a file with this name is an archive, even of a kind that cannot be opened here."""
    return bool(_ENDINGS.search(name) or _NOT_OPENED.search(name))


def archive_stem(name: str) -> str:
    """`work` for `work.tar.gz`; other names unchanged."""
    return _ENDINGS.sub("", name) or name


def open_archive(archive: Path, folder: Path, limits: Limits = USUAL) -> tuple[Remark, ...]:
    """Open `archive` into the new folder `folder`; returns what was left out or changed.

    Raises Refused for an archive that is too large, broken, encrypted or of another kind. Raises
    StorageError if it cannot be written (or `folder` exists already). Then nothing is left behind.
    """
    with storing(f"{archive.name} cannot be opened"):
        kind = _kind(archive)
        meter = Meter(limits, archive.stat().st_size)
        if kind == "zip":
            with zip_members(archive, limits) as members:
                return unpack(members, folder, meter)
        with tar_members(archive, meter) as stream:
            return unpack(stream, folder, meter)


def _kind(archive: Path) -> str:
    if not archive.is_file():
        raise Refused("This is not an ordinary file.")
    with archive.open("rb") as file:
        start = file.read(262)
    if any(start.startswith(magic) for magic in OPENERS) or start[257:] == b"ustar":
        return "tar"
    if start.startswith(b"PK"):
        return "zip"
    if not start:
        raise Refused("The archive is empty.", BROKEN_UPLOAD)
    raise Refused("This is not a zip or a tar.", "Ask for a zip, tar.gz, tar.bz2, or tar.xz.")


_PEOPLE = 10  # a zip of a whole class may have this many times the files of one submission


@dataclass(frozen=True)
class Opened:
    """One entry of the archive, at `path` (a file or a folder), which is None if the entry was refused.

    The last one may have no name: its findings are about entries that belong to nobody.
    """

    name: str
    path: Path | None
    findings: tuple[Remark, ...]


def zip_names(archive: Path, limits: Limits = USUAL) -> tuple[str, ...]:
    """The safe names in a zip. Raises Refused."""
    with storing(f"{archive.name} cannot be read"), zip_members(archive, _of_class(limits)) as members:
        return tuple(path for member in members if (path := _path(member)))


def open_parts(archive: Path, folder: Path, below: str = "", limits: Limits = USUAL) -> tuple[Opened, ...]:
    """Open each entry of the zip (or of its folder `below`) into a separate folder in `folder`.

    `limits` apply to each entry. What an earlier call left is replaced. Raises Refused if the zip as a
    whole cannot be read, and StorageError if it cannot be written.
    """
    with storing(f"{archive.name} cannot be opened"), zip_members(archive, _of_class(limits)) as members:
        parts = _by_name(members, f"{below}/" if below else "")
        unsafe = tuple(member.name for member in members if not _path(member) and member.name.strip("./"))
        opened = (_open_part(own, parts[own], folder / str(n), limits) for n, own in enumerate(parts))
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
        notes.add("Entries whose names lead outside the archive were left out.", name)
    if names:
        yield Opened("", None, notes.findings())


def _open_part(name: str, members: list[Member], folder: Path, limits: Limits) -> Opened:
    wipe(folder)
    meter = Meter(limits, sum(member.packed for member in members))
    try:
        return Opened(name, folder / name, unpack(members, folder, meter))
    except Refused as error:
        return Opened(name, None, (error.finding,))

"""Writes an archive's members into a new folder: files first, links last, all or nothing."""

from __future__ import annotations

import contextlib
import os
import secrets
import shutil
from collections.abc import Iterable, Iterator
from pathlib import Path, PurePosixPath
from typing import IO

from course.home.opening.broken import reading
from course.home.opening.finding import Finding, Notes
from course.home.opening.limits import Meter
from course.home.opening.member import Member
from course.home.opening.names import LONGEST_PATH, Unsafe, safe_path
from course.home.storage import PART

_STEP = 1 << 16

RENAMED = "Names with characters that cannot be printed were changed (to `_`)."
TWICE = "The archive holds more than one file of this name; the last one was taken."
BOTH = "A name stands for a file and a folder; the later one was left out."
LINK_OUT = "Links that lead out of the submission, or nowhere, were left out."
NO_FILE = "What is no ordinary file (a device, a pipe, a sparse file) was left out."


def unpack(members: Iterable[Member], folder: Path, meter: Meter) -> tuple[Finding, ...]:
    """Make `folder` of the members; returns what was left out or changed.

    Raises Refused when it is too much or broken, and OSError when the disk does not take it or
    `folder` is there already and not empty; then nothing new is left behind.
    """
    with made_whole(folder) as part:
        unpacking = _Unpacking(Path(os.path.realpath(part)), meter)
        for member in members:
            unpacking.take(member)
        unpacking.make_links()
    return unpacking.notes.findings()


@contextlib.contextmanager
def made_whole(folder: Path) -> Iterator[Path]:
    """A folder beside, which gets the name `folder` at the end, or is gone if there was an error."""
    for left in folder.parent.glob(f".{_beside(folder)}*{PART}"):  # of a killed command
        shutil.rmtree(left, ignore_errors=True)
    part = folder.with_name(f".{_beside(folder)}{secrets.token_hex(4)}{PART}")
    part.mkdir(parents=True)
    try:
        yield part
        part.rename(folder)
    except BaseException:
        shutil.rmtree(part, ignore_errors=True)
        raise


def _beside(folder: Path) -> str:
    return f"{folder.name[:60]}.".replace("[", "_").replace("*", "_").replace("?", "_")


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
        """A hard link becomes a file of its own. No link has been made yet that could lead away."""
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
        """Only now, so that nothing was written through one; and only those that stay inside."""
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
        real = Path(os.path.realpath(link))
        return real.is_relative_to(self._top) and real.exists() and not real.is_symlink()


@contextlib.contextmanager
def _opened(member: Member) -> Iterator[IO[bytes]]:
    with reading():
        content = member.open()
    with content as stream:
        yield stream


def _some(content: IO[bytes]) -> bytes:
    with reading():
        return content.read(_STEP)

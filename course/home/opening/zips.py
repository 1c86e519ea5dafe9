"""Zip archives: their members, and the traps that only zips have."""

from __future__ import annotations

import contextlib
import io
import stat
import zipfile
from collections.abc import Iterable, Iterator
from functools import partial
from pathlib import Path

from course.home.opening.broken import reading
from course.home.opening.finding import Refused
from course.home.opening.limits import ADVICE, Limits
from course.home.opening.member import Kind, Member

_ENCRYPTED, _UTF8 = 0x1, 0x800
_UNIX = 3
_LONGEST_TARGET = 4096
# An entry of the list of contents is 46 bytes, its name, and some extras.
_LIST_BYTES_PER_FILE = 256
# Other methods have no bound on what a few bytes become at once.
_METHODS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)


@contextlib.contextmanager
def zip_members(archive: Path, limits: Limits) -> Iterator[list[Member]]:
    """The members, readable in any order while the block lasts. Raises Refused."""
    with _Bounded(archive, max(65536, limits.files * _LIST_BYTES_PER_FILE)) as stream:
        with reading():
            opened = zipfile.ZipFile(stream)
        with opened:
            infos = opened.infolist()
            _refuse(infos)
            yield [_member(opened, info) for info in infos]


class _Bounded(io.BufferedReader):
    """A file of which no more than `most` bytes are read at once.

    zipfile reads the list of contents in one go, and makes an object of each entry.
    """

    def __init__(self, file: Path, most: int) -> None:
        super().__init__(io.FileIO(file))
        self._most = most
        self._size = file.stat().st_size

    def read(self, size: int | None = -1, /) -> bytes:
        wanted = self._size - self.tell() if size is None or size < 0 else size
        if wanted > self._most:
            raise Refused("Its list of contents is longer than any submission's.", ADVICE)
        return super().read(size)


def _refuse(infos: Iterable[zipfile.ZipInfo]) -> None:
    end = 0
    for info in sorted(infos, key=lambda info: info.header_offset):
        if info.flag_bits & _ENCRYPTED:
            raise Refused("The archive is encrypted.", "Ask for it without a password.", info.filename)
        if info.compress_type not in _METHODS:
            what = "The archive is compressed in a way that is not opened here."
            raise Refused(what, "Ask for an ordinary zip (method «deflate»).", info.filename)
        if info.header_offset < end:
            raise Refused("Its files overlap within the archive, as in traps.", ADVICE, info.filename)
        end = info.header_offset + 30 + len(info.orig_filename) + info.compress_size


def _member(opened: zipfile.ZipFile, info: zipfile.ZipInfo) -> Member:
    mode = info.external_attr >> 16 if info.create_system == _UNIX else 0
    name = _name(info)
    kind = _kind(name, mode)
    target = _target(opened, info) if kind == "link" else ""
    executable = bool(mode & stat.S_IXUSR)
    return Member(name, kind, partial(opened.open, info), executable, target, info.compress_size)


def _kind(name: str, mode: int) -> Kind:
    if name.endswith("/") or stat.S_ISDIR(mode):
        return "folder"
    if stat.S_ISLNK(mode):
        return "link"
    return "file" if stat.S_ISREG(mode) or stat.S_IFMT(mode) == 0 else "other"


def _target(opened: zipfile.ZipFile, info: zipfile.ZipInfo) -> str:
    with reading(), opened.open(info) as content:
        return content.read(_LONGEST_TARGET).decode("utf-8", "surrogateescape")


def _name(info: zipfile.ZipInfo) -> str:
    """With slashes (some Windows programs write backslashes), and in UTF-8 where it says so or not."""
    name = info.orig_filename.split("\0")[0]
    if not info.flag_bits & _UTF8:
        with contextlib.suppress(UnicodeError):  # then it really is of an old DOS
            name = name.encode("cp437").decode("utf-8")
    return name.replace("\\", "/")

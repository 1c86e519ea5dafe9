"""Zip and tar archives: their members, in order, and the traps of each kind.

The standard library only lists and reads the members. `unpack` decides what is written where, so it does not
matter how the library of this Python version would extract them.
"""

from __future__ import annotations

import bz2
import contextlib
import gzip
import io
import lzma
import stat
import tarfile
import zipfile
from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import IO, Any, Literal, cast

from course.home.opening.findings import BROKEN_UPLOAD, SOURCES_ONLY, Limits, Meter, Refused, reading

Kind = Literal["file", "folder", "link", "hard link", "other"]


@dataclass(frozen=True)
class Member:
    """name, target: as they are in the archive, so do not trust them.

    open: opens a file's content; call it before you ask for the next member.
    target: where a link leads. packed: bytes in the archive; 0 if unknown.
    """

    name: str
    kind: Kind
    open: Callable[[], AbstractContextManager[IO[bytes]]]
    executable: bool = False
    target: str = ""
    packed: int = 0


OPENERS: dict[bytes, Callable[[Path], Any]] = {
    b"\x1f\x8b": gzip.GzipFile,
    b"BZh": bz2.BZ2File,
    b"\xfd7zXZ\0": lzma.LZMAFile,
}
_STEP = 1 << 16
# tarfile reads a header's extras (long names, attributes) in one go, and searches them slowly.
_LARGEST_EXTRA = 1 << 15
_HEADERS_OF_ONE = 1 << 19


@contextlib.contextmanager
def tar_members(archive: Path, meter: Meter) -> Iterator[Iterator[Member]]:
    """The members in order; read each one, if at all, before you ask for the next. Raises Refused."""
    with archive.open("rb") as file:
        start = file.read(6)
    opener = next((opener for magic, opener in OPENERS.items() if start.startswith(magic)), None)
    with opener(archive) if opener else archive.open("rb") as raw:
        yield _members(_Forward(raw, meter))


def _members(stream: _Forward) -> Iterator[Member]:
    with reading():
        tar = tarfile.TarFile(fileobj=cast("IO[bytes]", stream), errorlevel=2)
    while True:
        stream.begin_headers()
        with reading():
            info = tar.next()
        if info is None:
            break
        stream.begin_content()
        yield _member(tar, info)
    if stream.last.strip(b"\0"):  # tarfile accepts anything as the end; a complete archive ends with zeros
        raise Refused("The archive is broken.", BROKEN_UPLOAD)
    with reading():
        stream.drain()


def _member(tar: tarfile.TarFile, info: tarfile.TarInfo) -> Member:
    def content() -> IO[bytes]:
        return cast("IO[bytes]", tar.extractfile(info))

    return Member(info.name, _kind(info), content, bool(info.mode & 0o100), info.linkname)


def _kind(info: tarfile.TarInfo) -> Kind:
    if info.isdir():
        return "folder"
    if info.issym():
        return "link"
    if info.islnk():
        return "hard link"
    return "file" if info.isreg() and not info.issparse() else "other"


class _Forward:
    """Reads forward only, and counts all bytes. Can step back by one byte, because tarfile does that."""

    def __init__(self, raw: IO[bytes], meter: Meter) -> None:
        self.last = b""  # what was read last
        self._raw = raw
        self._meter = meter
        self._at = 0
        self._back = False
        self._headers: int | None = 0

    def begin_headers(self) -> None:
        self._headers = 0

    def begin_content(self) -> None:
        self._headers = None

    def tell(self) -> int:
        return self._at - self._back

    def seek(self, to: int) -> None:
        if to == self._at - 1 and self.last:
            self._back = True
        elif to < self.tell():
            raise tarfile.ReadError("a member that overlaps the one before it")
        while self.tell() < to:
            if not self._read(min(_STEP, to - self.tell())):
                raise EOFError

    def drain(self) -> None:
        """Read to the end, where gzip, bzip2 and xz compare their checksums."""
        while self._read(_STEP):
            pass

    def read(self, size: int) -> bytes:
        if self._headers is not None:
            self._headers += size
            if not 0 <= size <= _LARGEST_EXTRA or self._headers > _HEADERS_OF_ONE:
                raise tarfile.ReadError("a suspiciously large header")
        return self._read(size) if size else b""

    def _read(self, size: int) -> bytes:
        before = self.last[-1:] if self._back else b""
        self._back = False
        fresh = self._raw.read(size - len(before))
        self._at += len(fresh)
        self.last = before + fresh
        self._meter.passing(self._at)
        return self.last


_ENCRYPTED, _UTF8 = 0x1, 0x800
_UNIX = 3
_LONGEST_TARGET = 4096
# An entry in the list of contents has 46 bytes, its name, and some extras.
_LIST_BYTES_PER_FILE = 256
# With other methods, a few bytes can expand to any size in one step.
_METHODS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)


@contextlib.contextmanager
def zip_members(archive: Path, limits: Limits) -> Iterator[list[Member]]:
    """The members, which can be read in any order within the `with` block. Raises Refused."""
    with _Bounded(archive, max(65536, limits.files * _LIST_BYTES_PER_FILE)) as stream:
        with reading():
            opened = zipfile.ZipFile(stream)
        with opened:
            infos = opened.infolist()
            _refuse(infos)
            yield [_zip_member(opened, info) for info in infos]


class _Bounded(io.BufferedReader):
    """A file from which no more than `most` bytes are read at once.

    zipfile reads the whole list of contents at once, and makes an object for each entry.
    """

    def __init__(self, file: Path, most: int) -> None:
        super().__init__(io.FileIO(file))
        self._most = most
        self._size = file.stat().st_size

    def read(self, size: int | None = -1, /) -> bytes:
        wanted = self._size - self.tell() if size is None or size < 0 else size
        if wanted > self._most:
            raise Refused("Its list of contents is longer than any real submission's.", SOURCES_ONLY)
        return super().read(size)


def _refuse(infos: Iterable[zipfile.ZipInfo]) -> None:
    end = 0
    for info in sorted(infos, key=lambda info: info.header_offset):
        if info.flag_bits & _ENCRYPTED:
            raise Refused("The archive is encrypted.", "Ask for it without a password.", info.filename)
        if info.compress_type not in _METHODS:
            what = "The archive uses a compression method that is not supported here."
            raise Refused(what, "Ask for an ordinary zip (method `deflate`).", info.filename)
        if info.header_offset < end:
            raise Refused("Its files overlap, as in zip bombs.", SOURCES_ONLY, info.filename)
        end = info.header_offset + 30 + len(info.orig_filename) + info.compress_size


def _zip_member(opened: zipfile.ZipFile, info: zipfile.ZipInfo) -> Member:
    mode = info.external_attr >> 16 if info.create_system == _UNIX else 0
    name = _name(info)
    kind = _zip_kind(name, mode)
    target = _target(opened, info) if kind == "link" else ""
    executable = bool(mode & stat.S_IXUSR)
    return Member(name, kind, partial(opened.open, info), executable, target, info.compress_size)


def _zip_kind(name: str, mode: int) -> Kind:
    if name.endswith("/") or stat.S_ISDIR(mode):
        return "folder"
    if stat.S_ISLNK(mode):
        return "link"
    return "file" if stat.S_ISREG(mode) or stat.S_IFMT(mode) == 0 else "other"


def _target(opened: zipfile.ZipFile, info: zipfile.ZipInfo) -> str:
    with reading(), opened.open(info) as content:
        return content.read(_LONGEST_TARGET).decode("utf-8", "surrogateescape")


def _name(info: zipfile.ZipInfo) -> str:
    """The name, decoded as UTF-8, with slashes in place of the backslashes of some Windows programs."""
    name = info.orig_filename.split("\0")[0]
    if not info.flag_bits & _UTF8:
        with contextlib.suppress(UnicodeError):  # then it really is in the encoding of DOS
            name = name.encode("cp437").decode("utf-8")
    return name.replace("\\", "/")

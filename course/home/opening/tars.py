"""Tar archives, plain or compressed: their members, in order, in one pass.

Only the list of members is tarfile's; what is written where is decided by `unpack`, so that no
version's way of extracting matters.
"""

from __future__ import annotations

import bz2
import contextlib
import gzip
import lzma
import tarfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import IO, Any, cast

from course.home.opening.broken import ADVICE, reading
from course.home.opening.finding import Refused
from course.home.opening.limits import Meter
from course.home.opening.member import Kind, Member

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
    """The members in order; each is read, or not, before the next is asked for. Raises Refused."""
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
    if stream.last.strip(b"\0"):  # tarfile takes anything for the end; a whole archive ends with zeros
        raise Refused("The archive is broken.", ADVICE)
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
    """Reads forward only, counting all that passes; steps back by one byte, which tarfile does."""

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
            raise tarfile.ReadError("a member that begins before the one before it ends")
        while self.tell() < to:
            if not self._read(min(_STEP, to - self.tell())):
                raise EOFError

    def drain(self) -> None:
        """To the end, where gzip, bzip2 and xz keep the sums that tell whether all of it was right."""
        while self._read(_STEP):
            pass

    def read(self, size: int) -> bytes:
        if self._headers is not None:
            self._headers += size
            if not 0 <= size <= _LARGEST_EXTRA or self._headers > _HEADERS_OF_ONE:
                raise tarfile.ReadError("a header larger than any that is meant well")
        return self._read(size) if size else b""

    def _read(self, size: int) -> bytes:
        before = self.last[-1:] if self._back else b""
        self._back = False
        fresh = self._raw.read(size - len(before))
        self._at += len(fresh)
        self.last = before + fresh
        self._meter.passing(self._at)
        return self.last

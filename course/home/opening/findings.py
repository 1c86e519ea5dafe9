"""Why a submission is refused or changed: unsafe names, too much data, broken archives."""

from __future__ import annotations

import contextlib
import lzma
import re
import struct
import tarfile
import time
import zipfile
import zlib
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

LONGEST_NAME = 255  # bytes; the most that Linux allows
LONGEST_PATH = 1024  # bytes; leaves room for the path of the folder that everything goes into
DEEPEST = 32

_DRIVE = re.compile(r"[A-Za-z]:")


class Unsafe(Exception):
    """A name that leads elsewhere, or that no disk accepts; the text says which, as part of a sentence."""


def safe_path(name: str) -> str:
    """The relative path that `name` means, in printable characters. Raises Unsafe."""
    if name.startswith("/") or _DRIVE.match(name):
        raise Unsafe("an absolute path")
    parts = [part for part in name.split("/") if part not in ("", ".")]
    if ".." in parts:
        raise Unsafe("a path that leads outside (`..`)")
    if len(parts) > DEEPEST:
        raise Unsafe(f"more than {DEEPEST} folders deep")
    path = "/".join(safe_name(part) for part in parts)
    if len(path.encode()) > LONGEST_PATH:
        raise Unsafe(f"a path of more than {LONGEST_PATH} bytes")
    return path


def safe_name(name: str) -> str:
    """One file's name with an underscore for each character that cannot be printed. Raises Unsafe.

    These are control characters and escapes, line ends, marks that change the reading direction, and
    bytes that are not UTF-8 (which Python keeps as halves of surrogate pairs).
    """
    safe = name if name.isprintable() else "".join(c if c.isprintable() else "_" for c in name)
    if len(safe.encode()) > LONGEST_NAME:
        raise Unsafe(f"a name of more than {LONGEST_NAME} bytes")
    return safe


def visible(text: str, limit: int = 120) -> str:
    """`text` on one line, with unprintable characters escaped, and without its middle if it is long."""
    if len(text) > limit:
        text = f"{text[: limit // 2]}...{text[-(limit // 2) :]}"
    return "".join(char if char.isprintable() else char.encode("unicode_escape").decode() for char in text)


_NAMED = 3


@dataclass(frozen=True)
class Remark:
    """Something about a submission that a person should know: one sentence, and the next step.

    where: the files that it is about; at most three are named.
    """

    what: str
    advice: str | None = None
    where: str | None = None


class Refused(Exception):
    """A submission, or an archive, that is not accepted at all."""

    def __init__(self, what: str, advice: str | None = None, where: str | None = None) -> None:
        super().__init__(what)
        self.finding = Remark(what, advice, where)


class Notes:
    """Collects what was left out or changed: one finding for each reason, however many files it affects."""

    def __init__(self) -> None:
        self._count: Counter[tuple[str, str | None]] = Counter()
        self._names: dict[tuple[str, str | None], list[str]] = {}

    def add(self, what: str, name: str, advice: str | None = None) -> None:
        names = self._names.setdefault((what, advice), [])
        self._count[what, advice] += 1
        if len(names) < _NAMED:
            names.append(visible(name))

    def findings(self) -> tuple[Remark, ...]:
        return tuple(Remark(*reason, self._where(reason)) for reason in self._names)

    def _where(self, reason: tuple[str, str | None]) -> str:
        more = self._count[reason] - len(self._names[reason])
        return ", ".join(self._names[reason]) + (f" and {more} more" if more else "")


SOURCES_ONLY = "Hand in the source files only: no build/, install/, log/, virtual environment or recordings."
_HEADERS = 4096  # bytes that a file may take in a tar in addition to its content


@dataclass(frozen=True)
class Limits:
    """bytes: of all files together. files: files, folders and links. file: bytes of one file.

    ratio: how many times its packed size an archive may unpack to, once that is more than `free` bytes.
    seconds: of CPU time that opening one archive may take, so other programs on the machine do not count.
    """

    bytes: int = 500_000_000
    files: int = 20_000
    file: int = 200_000_000
    ratio: int = 200
    free: int = 20_000_000
    seconds: float = 60.0


USUAL = Limits()


class Meter:
    """Counts the files and bytes that come out of an archive. Raises Refused as soon as there are too many.

    packed: the size of the archive, in bytes; None for plain files.
    """

    def __init__(self, limits: Limits, packed: int | None = None) -> None:
        self.limits = limits
        self.files = 0
        self.bytes = 0
        self._unpacked = limits.bytes if packed is None else max(limits.free, packed * limits.ratio)
        self._end = time.thread_time() + limits.seconds

    def entry(self) -> None:
        """Count one more file, folder or link."""
        self.files += 1
        if self.files > self.limits.files:
            raise Refused(f"It contains more than {self.limits.files:,} files.", SOURCES_ONLY)
        self.on_time()

    def data(self, count: int, of_file: int, name: str) -> None:
        """Count `count` more bytes; with them, the file has `of_file` bytes."""
        self.bytes += count
        if of_file > self.limits.file:
            raise Refused(
                f"One of its files is larger than {megabytes(self.limits.file)}.", SOURCES_ONLY, name
            )
        self._total(self.bytes)
        self.on_time()

    def passing(self, count: int) -> None:
        """Report that `count` bytes have come out, including headers and entries that are left out."""
        self._total(count - self.files * _HEADERS)
        self.on_time()

    def _total(self, count: int) -> None:
        if count > self.limits.bytes:
            raise Refused(f"It contains more than {megabytes(self.limits.bytes)}.", SOURCES_ONLY)
        if count > self._unpacked:
            what = f"It unpacks to more than {self.limits.ratio} times its archive's size, as zip bombs do."
            raise Refused(what, SOURCES_ONLY)

    def on_time(self) -> None:
        if time.thread_time() > self._end:
            raise Refused(
                f"It takes more than {self.limits.seconds:.0f} s of computing to open.", SOURCES_ONLY
            )


def megabytes(count: int) -> str:
    return f"{count / 1e6:,.0f} MB"


BROKEN = (
    zipfile.BadZipFile,
    tarfile.TarError,
    zlib.error,
    lzma.LZMAError,
    struct.error,
    EOFError,
    NotImplementedError,  # a zip version or compression that zipfile does not know
    RecursionError,  # headers of headers of headers
    ArithmeticError,
    LookupError,
    ValueError,  # invalid numbers, names that are not text
    TypeError,
)
BROKEN_UPLOAD = "Ask for it again; the upload may have been cut off."


@contextlib.contextmanager
def reading() -> Iterator[None]:
    """Turn errors of the standard library's readers into Refused; put only calls of these inside.

    An OSError with a number comes from the machine (a full or missing disk), and is raised as it is.
    """
    try:
        yield
    except BROKEN as error:
        raise Refused("The archive is broken.", BROKEN_UPLOAD) from error
    except OSError as error:
        if error.errno is not None:
            raise
        raise Refused("The archive is broken.", BROKEN_UPLOAD) from error

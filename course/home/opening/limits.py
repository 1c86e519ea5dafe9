"""How much one submission may be, and the meter that counts while it is opened or copied."""

from __future__ import annotations

import time
from dataclasses import dataclass

from course.home.opening.finding import Refused

ADVICE = "Hand in the source files only: no build/, install/, log/, virtual environment or recordings."
_HEADERS = 4096  # bytes that a file may take in a tar beside its content


@dataclass(frozen=True)
class Limits:
    """bytes: of all files together. files: files, folders and links. file: bytes of one file.

    ratio: how many times its packed size an archive may become, once it is larger than `free` bytes.
    seconds: of computing, that opening one archive may take; a busy machine makes it no longer.
    """

    bytes: int = 500_000_000
    files: int = 20_000
    file: int = 200_000_000
    ratio: int = 200
    free: int = 20_000_000
    seconds: float = 60.0


USUAL = Limits()


class Meter:
    """Counts what comes out. Raises Refused as soon as it is too much.

    packed: the size of the archive that it comes out of, in bytes; None for plain files.
    """

    def __init__(self, limits: Limits, packed: int | None = None) -> None:
        self.limits = limits
        self.files = 0
        self.bytes = 0
        self._unpacked = limits.bytes if packed is None else max(limits.free, packed * limits.ratio)
        self._end = time.thread_time() + limits.seconds

    def entry(self) -> None:
        """One more file, folder or link."""
        self.files += 1
        if self.files > self.limits.files:
            raise Refused(f"It holds more than {self.limits.files:,} files.", ADVICE)
        self.on_time()

    def data(self, count: int, of_file: int, name: str) -> None:
        """`count` more bytes, the file's `of_file` in all."""
        self.bytes += count
        if of_file > self.limits.file:
            raise Refused(f"One of its files is larger than {megabytes(self.limits.file)}.", ADVICE, name)
        self._total(self.bytes)
        self.on_time()

    def passing(self, count: int) -> None:
        """So many bytes of the archive have come out, headers and what is left out among them."""
        self._total(count - self.files * _HEADERS)
        self.on_time()

    def _total(self, count: int) -> None:
        if count > self.limits.bytes:
            raise Refused(f"It holds more than {megabytes(self.limits.bytes)}.", ADVICE)
        if count > self._unpacked:
            what = f"It becomes more than {self.limits.ratio} times as large as its archive, as traps do."
            raise Refused(what, ADVICE)

    def on_time(self) -> None:
        if time.thread_time() > self._end:
            raise Refused(
                f"It takes more than {self.limits.seconds:.0f} s of computing to be opened.", ADVICE
            )


def megabytes(count: int) -> str:
    return f"{count / 1e6:,.0f} MB"

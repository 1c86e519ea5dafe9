"""What a submission's build writes: how much of it, and whether all of it may stay.

A build that writes too much is stopped. Afterwards, what it wrote becomes ours, and anything that could
lead a reader astray is removed.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import stat
import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

from course.isolation.watchdog import DISK

FILES = "files"
MOST_FILES = 50_000
# CMake's own folders are nested a dozen deep.
MOST_DEPTH = 60
# Characters. The kernel takes 4096 bytes, so another name fits after this, even at four bytes a character.
LONGEST_PATH = 700
_EVERY = 1.0
# A disk with fewer free bytes may be full before it is looked at again.
LOW = 64 * 1024 * 1024


@dataclass(frozen=True)
class Flaw:
    """What must not be in a tree. why: "link" (it leads out), "kind" (neither file nor folder), "size"."""

    why: str
    name: str


def seal(top: Path, within: Path) -> Flaw | None:
    """Make all in `top` ours and readable by everyone; returns the first thing that must not be there.

    Links may lead to anything in `within`, a folder around it. Flawed links and special files are removed.
    After "size", the rest stays as it was. Nobody may write to the tree meanwhile.
    """
    home, flaw = within.resolve(), None
    for number, (path, status) in enumerate(_entries(top)):
        deep = len(path.parts) - len(top.parts) > MOST_DEPTH or len(str(path)) > LONGEST_PATH
        if deep or number >= MOST_FILES:
            return Flaw("size", path.relative_to(top).parts[0])
        found = _flaw(path, status, home)
        if found:
            path.unlink()
            flaw = flaw or Flaw(found, str(path.relative_to(top)))
    return flaw


def _entries(top: Path) -> Iterator[tuple[Path, os.stat_result]]:
    """Everything in a folder. Uses an explicit stack, because a deep tree would exceed Python's."""
    waiting = [top] if top.is_dir() and not top.is_symlink() else []
    while waiting:
        folder = waiting.pop()
        _take(folder, folder.lstat())
        with os.scandir(folder) as found:
            entries = list(islice(found, MOST_FILES + 1))
        for entry in entries:
            path = Path(entry.path)
            status = entry.stat(follow_symlinks=False)
            if entry.is_dir(follow_symlinks=False):
                waiting.append(path)
            yield path, status


def _flaw(path: Path, status: os.stat_result, home: Path) -> str | None:
    if stat.S_ISLNK(status.st_mode):
        try:
            leads_out = not path.resolve().is_relative_to(home)
        except (OSError, RuntimeError):  # links in a circle
            leads_out = True
        return "link" if leads_out else None
    if stat.S_ISREG(status.st_mode):
        _take(path, status)
    elif not stat.S_ISDIR(status.st_mode):
        return "kind"
    return None


def _take(path: Path, status: os.stat_result) -> None:
    if status.st_uid != os.geteuid():
        os.chown(path, os.geteuid(), os.getegid(), follow_symlinks=False)
    mode = stat.S_IMODE(status.st_mode)
    readable = 0o755 if stat.S_ISDIR(status.st_mode) or mode & stat.S_IXUSR else 0o644
    if mode != readable:
        path.chmod(readable)


class DiskUsage:
    """Folders on a disk that others use, too. most: bytes for all together.

    total: bytes in them at the last look. was_low: whether the disk was ever seen nearly full.
    """

    def __init__(self, tops: Iterable[Path], most: int) -> None:
        self._tops = tuple(tops)
        self._most = most
        self._next = 0.0
        self.total = 0
        self.was_low = False

    def look(self) -> str | None:
        """What there is too much of, DISK or FILES; None if nothing is, or if it was asked a moment ago."""
        low = any(shutil.disk_usage(top).free < LOW for top in self._tops[:1] if top.exists())
        self.was_low = self.was_low or low
        if time.monotonic() < self._next and not low:
            return None
        found = self.now()
        self._next = time.monotonic() + _EVERY
        return found

    def now(self) -> str | None:
        """Like `look`, but never skipped. With an explicit stack, since a deep tree would exceed Python's."""
        waiting = [(str(top), 0) for top in self._tops]
        self.total = number = 0
        while waiting:
            folder, depth = waiting.pop()
            if depth > MOST_DEPTH or len(folder) > LONGEST_PATH:
                return FILES
            for entry in _children(folder):
                number += 1
                if number > MOST_FILES:
                    return FILES
                with contextlib.suppress(OSError):
                    self.total += entry.stat(follow_symlinks=False).st_blocks * 512
                    if entry.is_dir(follow_symlinks=False):
                        waiting.append((entry.path, depth + 1))
                if self.total >= self._most:
                    return DISK
        return None


def _children(folder: str) -> list[os.DirEntry[str]]:
    """Empty if the folder has disappeared. An unreadable one is counted after we own it again."""
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        return list(islice(entries, MOST_FILES + 1))
    return []

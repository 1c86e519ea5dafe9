"""How much a build has written: more than a build may, and it is stopped."""

from __future__ import annotations

import contextlib
import os
import time
from collections.abc import Iterable
from itertools import islice
from pathlib import Path

from course.arena.sandbox.watchdog import DISK

FILES = "files"
MOST_FILES = 50_000
# CMake's own folders lie a dozen deep in one another.
MOST_DEPTH = 60
# Of the 4096 bytes that the kernel takes, so that a name of four bytes a character fits behind it.
LONGEST_PATH = 700
_EVERY = 1.0


class Usage:
    """Folders on a disk that others use, too. most: bytes for all together."""

    def __init__(self, tops: Iterable[Path], most: int) -> None:
        self._tops = tuple(tops)
        self._most = most
        self._next = 0.0

    def look(self) -> str | None:
        """What there is too much of, DISK or FILES; says None, too, when it has just been asked."""
        if time.monotonic() < self._next:
            return None
        found = self.now()
        self._next = time.monotonic() + _EVERY
        return found

    def now(self) -> str | None:
        """The same, looked at in any case. With a stack of our own: Python's ends before deep trees do."""
        waiting = [(str(top), 0) for top in self._tops]
        total = number = 0
        while waiting:
            folder, depth = waiting.pop()
            if depth > MOST_DEPTH or len(folder) > LONGEST_PATH:
                return FILES
            for entry in _entries(folder):
                number += 1
                if number > MOST_FILES:
                    return FILES
                with contextlib.suppress(OSError):
                    total += entry.stat(follow_symlinks=False).st_blocks * 512
                    if entry.is_dir(follow_symlinks=False):
                        waiting.append((entry.path, depth + 1))
                if total >= self._most:
                    return DISK
        return None


def _entries(folder: str) -> list[os.DirEntry[str]]:
    """None of a folder that is gone meanwhile; one that is shut can be counted once it is ours again."""
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        return list(islice(entries, MOST_FILES + 1))
    return []

"""A copy of the part of the course home that an exercise needs, for programs to run in.

The learner's own home is only read: whatever their programs write, they write into the copy.
"""

from __future__ import annotations

import contextlib
import shutil
from collections.abc import Iterable
from pathlib import Path

from course.evidence.home_files import HomeEntry

# The copy may lie in memory; files of an exercise are small.
MAX_FILE = 8 * 1024 * 1024
MAX_TOTAL = 64 * 1024 * 1024


def lay_home(home: Path, entries: Iterable[HomeEntry], target: Path) -> None:
    """Copy what was looked at, with its modes, to `target`. What cannot be read or is huge is left out."""
    target.mkdir(parents=True, exist_ok=True)
    left = MAX_TOTAL
    folders: list[HomeEntry] = []
    for entry in entries:
        copy = target / entry.path
        with contextlib.suppress(OSError):
            copy.parent.mkdir(parents=True, exist_ok=True)
            if entry.kind == "folder":
                copy.mkdir(exist_ok=True)
                folders.append(entry)
            elif entry.kind == "file" and entry.size <= min(MAX_FILE, left):
                left -= entry.size
                shutil.copyfile(home / entry.path, copy)
                copy.chmod(entry.mode)
    for entry in reversed(folders):  # a folder that may not be written, only after it has been filled
        with contextlib.suppress(OSError):
            (target / entry.path).chmod(entry.mode | 0o700)

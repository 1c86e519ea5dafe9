"""Takes back what a submission's build wrote, and leaves nothing in it that could lead a reader astray."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

from course.build.usage import LONGEST_PATH, MOST_DEPTH, MOST_FILES


@dataclass(frozen=True)
class Flaw:
    """What must not be in a tree. why: "link" (it leads out), "kind" (neither file nor folder), "size"."""

    why: str
    name: str


def seal(top: Path, within: Path) -> Flaw | None:
    """All in `top` becomes ours, and readable by everyone; returns the first thing that must not be there.

    Links may lead to what is `within` the folder around it. Flawed links and special files are removed.
    After "size" the rest is as it was. Nobody may write to the tree meanwhile.
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
    """With a stack of our own: Python's would end before the deepest tree does."""
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

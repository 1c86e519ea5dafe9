"""Where programs run, and their home: a copy of the part of the course home that an exercise needs.

The learner's own home is only read: their programs write to the copy. The grading process writes the copy
before the first program starts, and afterwards only reads it.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import stat
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from fnmatch import fnmatchcase
from itertools import islice
from pathlib import Path, PurePosixPath

import psutil

from course.evidence.home_files import HomeEntry
from course.evidence.sources import MAX_DEPTH, MAX_FILES
from course.files import wipe
from course.isolation.isolation_plan import Starter
from course.isolation.none import end_descendants
from course.isolation.sandbox import start_here

# The copy may be in memory; files of an exercise are small.
MAX_FILE = 8 * 1024 * 1024
MAX_TOTAL = 64 * 1024 * 1024
HOME = "home"


class ScratchHome:
    """Reads the home in the folder `scratch` while hostile programs may be writing to it.

    They can replace anything with a link, a pipe or another folder at any moment. So each step of a path is
    opened separately, and links are never followed. All paths are relative to the home.
    """

    def __init__(self, scratch: Path) -> None:
        self._scratch = scratch

    def read(self, path: str, most: int = MAX_FILE) -> bytes | None:
        """Return at most the first `most` bytes of a file; None if it is not a regular file."""
        with contextlib.suppress(OSError), self._opened(path, os.O_RDONLY | os.O_NONBLOCK) as descriptor:
            if stat.S_ISREG(os.fstat(descriptor).st_mode):
                with open(descriptor, "rb", closefd=False) as stream:
                    return stream.read(most)
        return None

    def text(self, path: str) -> str | None:
        """Return a file's text as `read` does, with invalid UTF-8 replaced."""
        data = self.read(path)
        return None if data is None else data.decode("utf-8", errors="replace")

    def is_file(self, path: str) -> bool:
        """Whether this is a regular file and not a link to one."""
        return stat.S_ISREG(self._mode(path))

    def is_folder(self, path: str) -> bool:
        """Whether this is a folder and not a link to one."""
        return stat.S_ISDIR(self._mode(path))

    def is_link(self, path: str) -> bool:
        """Whether this is a symbolic link, wherever it leads."""
        return stat.S_ISLNK(self._mode(path))

    def matching(self, pattern: str) -> tuple[str, ...]:
        """Return the sorted paths of the files matching the pattern (`src/*.cpp`; `*` does not match `/`)."""
        found = [PurePosixPath()]
        for part in PurePosixPath(pattern).parts:
            names = ((at, name) for at in found for name in self._names(str(at)))
            fitting = (at / name for at, name in names if fnmatchcase(name, part))
            found = list(islice(fitting, 2 * MAX_FILES))
        return tuple(sorted(path for path in map(str, found) if self.is_file(path)))

    def below(self, folder: str) -> tuple[str, ...]:
        """Return the sorted paths of the files in a folder and its subfolders, up to a limit."""
        patterns = (str(PurePosixPath(folder, *["*"] * depth)) for depth in range(1, MAX_DEPTH))
        found = (file for pattern in patterns for file in self.matching(pattern))
        return tuple(sorted(islice(found, MAX_FILES)))

    def _names(self, folder: str) -> list[str]:
        with (
            contextlib.suppress(OSError),
            self._opened(folder, os.O_RDONLY | os.O_DIRECTORY) as descriptor,
            os.scandir(descriptor) as entries,
        ):
            return [entry.name for entry in islice(entries, 2 * MAX_FILES)]
        return []

    def _mode(self, path: str) -> int:
        with contextlib.suppress(OSError), self._opened(path, os.O_PATH) as descriptor:
            return os.fstat(descriptor).st_mode
        return 0

    @contextlib.contextmanager
    def _opened(self, path: str, flags: int) -> Iterator[int]:
        """A descriptor for what is at `path`. Raises OSError, even if there is only a link on the way."""
        *folders, last = (HOME, *PurePosixPath(path).parts)
        current = os.open(self._scratch, os.O_PATH | os.O_DIRECTORY | os.O_CLOEXEC)
        try:
            for name in folders:
                current = _step(current, name, os.O_PATH | os.O_DIRECTORY)
            current = _step(current, last, flags)
            yield current
        finally:
            os.close(current)


def _step(folder: int, name: str, flags: int) -> int:
    """Open `name` in the folder, and close the folder."""
    if name in ("/", ".."):
        raise PermissionError(f"{name} leads out of the home")
    following = os.open(name, flags | os.O_NOFOLLOW | os.O_CLOEXEC, dir_fd=folder)
    os.close(folder)
    return following


def lay_home(
    home: Path, entries: Iterable[HomeEntry], target: Path, files: Mapping[str, str] | None = None
) -> None:
    """Copy what the exercise looks at, with its modes, to `target`; unreadable or huge files are left out.

    files: texts by path that replace what is there. No program may be running in `target`.
    """
    files = files or {}
    target.mkdir(parents=True, exist_ok=True)
    left = MAX_TOTAL
    folders: list[HomeEntry] = []
    for entry in entries:
        copy = target / entry.path
        if _makes_way(entry, files):
            continue
        with contextlib.suppress(OSError):
            copy.parent.mkdir(parents=True, exist_ok=True)
            if entry.kind == "folder":
                copy.mkdir(exist_ok=True)
                folders.append(entry)
            elif entry.kind == "file" and entry.size <= min(MAX_FILE, left):
                left -= entry.size
                shutil.copyfile(home / entry.path, copy)
                copy.chmod(entry.mode)
    for path, text in files.items():
        (target / path).parent.mkdir(parents=True, exist_ok=True)
        (target / path).write_text(text, encoding="utf-8")
    for entry in reversed(folders):  # after filling them, because some are read-only
        with contextlib.suppress(OSError):
            (target / entry.path).chmod(entry.mode | 0o700)


def _makes_way(entry: HomeEntry, files: Mapping[str, str]) -> bool:
    """Whether this entry must give way to one of the files, at the same path, above it, or inside it."""
    path = PurePosixPath(entry.path)
    return any(
        path.is_relative_to(file) or (entry.kind != "folder" and PurePosixPath(file).is_relative_to(path))
        for file in files
    )


@dataclass(frozen=True)
class Place:
    """Where programs run. start: starts them. home: their home.

    require_ours: raises Spoilt if anyone has killed what keeps the place up; called before leaving it.
    """

    start: Starter
    home: ScratchHome
    require_ours: Callable[[], None] = lambda: None


# Opens an unused place. Its home is as it was at the beginning, except for these texts by path.
OpenPlace = Callable[[Mapping[str, str]], contextlib.AbstractContextManager[Place]]


@contextlib.contextmanager
def place_without_sandbox(scratch: Path, fill: Callable[[Path], None]) -> Iterator[Place]:
    """The closest match without a sandbox: an empty `scratch`; at its end, all started programs end."""
    before = scratch.with_name(f"{scratch.name}.before")
    if scratch.exists():
        scratch.rename(before)
    scratch.mkdir(parents=True)
    spared = psutil.Process().children()
    try:
        fill(scratch)
        yield Place(start_here, ScratchHome(scratch))
    finally:
        end_descendants(spared)
        wipe(scratch)
        if before.exists():
            before.rename(scratch)

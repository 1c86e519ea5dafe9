"""The files of a submission on disk: walked within bounds, with links resolved and leftovers skipped."""

from __future__ import annotations

import contextlib
import os
import re
import stat
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from course.batch.intake.submission import Part
from course.content.layout import STATE, WORKSPACE
from course.home.opening import USUAL, Limits, Meter, Notes, Remark, Unsafe, safe_name
from course.home.opening.findings import DEEPEST, megabytes
from course.home.opening.unpack import LINK_OUT, NO_FILE, RENAMED, leads_inside

# What systems, tools and editors leave behind. `.ros2course` is searched: see `_KEPT_STATE`.
_LEFT_BY_TOOLS = frozenset(
    "__MACOSX .DS_Store Thumbs.db desktop.ini .git .hg .svn .github __pycache__ .pytest_cache .mypy_cache "
    ".ruff_cache .vscode .idea .venv node_modules".split()
)
_BUILT = frozenset({"build", "install", "log"})
_BUILT_BESIDE = frozenset({"src", "package.xml"})
_BUILT_INSIDE = frozenset({"COLCON_IGNORE", ".built_by", "setup.bash"})
_NO_NAME = re.compile(r"\A\.{0,2}\Z")  # such as `..`, which is what remains of `...zip`
PACKED = "hand-in.json"  # the manifest of `pack`
RESULTS = "grades.sqlite3"  # what `grade` writes first
RESULTS_LEFT_OUT = "Results of `grade` were left out."
# A folder that contains one of these is a submission.
ONE = frozenset({WORKSPACE, STATE, "src", "package.xml"})
_STEP = 1 << 18
_KEPT_STATE = frozenset({"home.json", "acts", PACKED})


@dataclass(frozen=True)
class TreeEntry:
    """One file or folder; `path` is its real path. size: bytes, 0 for a folder."""

    path: Path
    folder: bool
    size: int = 0
    executable: bool = False


@dataclass(frozen=True)
class Tree:
    """entries: by relative path, in safe characters, folders before what is in them.

    parts: names of the parts, if there are several, in the order in which they were given.
    """

    entries: Mapping[str, TreeEntry]
    findings: tuple[Remark, ...]
    parts: tuple[str, ...] = ()

    def folders(self) -> frozenset[str]:
        return frozenset(path for path, entry in self.entries.items() if entry.folder)

    def files(self) -> frozenset[str]:
        return frozenset(path for path, entry in self.entries.items() if not entry.folder)


def is_results(folder: Path) -> bool:
    """Whether `grade` keeps results there. A folder that can be a submission never counts as such."""
    with contextlib.suppress(OSError):
        return (folder / RESULTS).is_file() and not any(os.path.lexists(folder / name) for name in ONE)
    return False


def holds_only_results(folder: Path) -> bool:
    """Whether it contains nothing but folders of results, at any depth."""
    found = False
    for path, folders, files in os.walk(folder):
        if is_results(Path(path)):
            found = True
            folders.clear()
        elif files or path.count(os.sep) > f"{folder}".count(os.sep) + DEEPEST:
            return False
    return found


def read_into(entry: TreeEntry, take: Callable[[bytes], object]) -> bool:
    """Give `take` the bytes of a file, but no more than it had when the tree was read.

    Returns False if it cannot be read, or is no longer an ordinary file.
    """
    try:
        descriptor = os.open(entry.path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
    except OSError:
        return False
    try:
        left = entry.size if stat.S_ISREG(os.fstat(descriptor).st_mode) else -1
        while left > 0 and (data := _piece(descriptor, left)):
            left -= len(data)
            take(data)
        return left >= 0
    finally:
        os.close(descriptor)


def _piece(descriptor: int, most: int) -> bytes:
    with contextlib.suppress(OSError):
        return os.read(descriptor, min(_STEP, most))
    return b""


def content(entry: TreeEntry) -> bytes | None:
    """The whole content of a file; None if it cannot be read."""
    pieces: list[bytes] = []
    return b"".join(pieces) if read_into(entry, pieces.append) else None


def read_tree(parts: Iterable[Part], limits: Limits = USUAL) -> Tree:
    """Read all files of the parts. A single folder is the tree itself; several parts keep their names.

    Raises Refused if it is too much.
    """
    every = tuple(parts)
    walk = _Walk(limits)
    names = []
    for part in every:
        alone = len(every) == 1 and part.path.is_dir()
        names.append("" if alone else walk.unique(part.name))
        walk.part(part.path, names[-1])
    return Tree(walk.entries, walk.notes.findings(), tuple(names))


class _Walk:
    def __init__(self, limits: Limits) -> None:
        self.entries: dict[str, TreeEntry] = {}
        self.notes = Notes()
        self._limits = limits
        self._meter = Meter(limits)

    def unique(self, name: str) -> str:
        first = name = _NO_NAME.sub("part", safe_name(name).replace("/", "_"))
        number = 1
        while name in self.entries:
            number += 1
            name = f"{first}-{number}"
        return name

    def part(self, path: Path, name: str) -> None:
        """Add a file, or a folder with everything in it. name: "" for a single folder."""
        real = Path(os.path.realpath(path))
        if not real.is_dir():
            self._add(real, name, real.parent, ())
            return
        if name:
            self.entries[name] = TreeEntry(real, folder=True)
        self._inside(real, name, real, (real,))

    def _inside(self, folder: Path, prefix: str, top: Path, above: tuple[Path, ...]) -> None:
        """Add what is in a folder, without leftovers. above: the real folders down to this one."""
        try:
            names = self._names(folder)
        except OSError:
            self.notes.add("Folders without read permission were left out.", prefix)
            return
        if prefix and "pyvenv.cfg" in names:
            return
        state = folder.name == STATE
        for name in sorted(names):
            if not _is_left_over(name, names, state):
                self._named(folder / name, prefix, top, above)

    def _names(self, folder: Path) -> set[str]:
        names = set()
        with os.scandir(folder) as found:
            for entry in found:
                self._meter.entry()
                names.add(entry.name)
        return names

    def _named(self, path: Path, prefix: str, top: Path, above: tuple[Path, ...]) -> None:
        try:
            safe = safe_name(path.name)
        except Unsafe as error:
            self.notes.add(f"Entries with {error} were left out.", path.name)
            return
        name = f"{prefix}/{safe}" if prefix else safe
        if safe != path.name:
            self.notes.add(RENAMED, path.name)
        if name in self.entries:
            self.notes.add("Where names became the same, only the first was used.", path.name)
        else:
            self._add(path, name, top, above)

    def _add(self, path: Path, name: str, top: Path, above: tuple[Path, ...]) -> None:
        """Treat a link as its target if that is inside `top`."""
        real = Path(os.path.realpath(path)) if path.is_symlink() else path
        if real is not path and not leads_inside(path, top):
            self.notes.add(LINK_OUT, name)
        elif real.is_dir():
            self._folder(real, name, top, above)
        elif real.is_file():
            self._file(real, name)
        else:
            self.notes.add(NO_FILE, name)

    def _folder(self, real: Path, name: str, top: Path, above: tuple[Path, ...]) -> None:
        if real in above:
            self.notes.add("Links to a folder that contains them were left out.", name)
        elif len(above) > DEEPEST:
            self.notes.add(f"Folders more than {DEEPEST} deep were left out.", name)
        elif is_results(real):
            self.notes.add(RESULTS_LEFT_OUT, name)
        elif not (real.name in _BUILT and any((real / mark).exists() for mark in _BUILT_INSIDE)):
            self.entries[name] = TreeEntry(real, folder=True)
            self._inside(real, name, top, (*above, real))

    def _file(self, real: Path, name: str) -> None:
        status = real.stat()
        if status.st_size > self._limits.file:
            self.notes.add(f"Files larger than {megabytes(self._limits.file)} were left out.", name)
            return
        self._meter.data(status.st_size, status.st_size, name)
        self.entries[name] = TreeEntry(real, False, status.st_size, bool(status.st_mode & 0o100))


def _is_left_over(name: str, beside: set[str], state: bool) -> bool:
    built = name in _BUILT and not _BUILT_BESIDE.isdisjoint(beside)
    return built or name in _LEFT_BY_TOOLS or name.startswith("._") or (state and name not in _KEPT_STATE)

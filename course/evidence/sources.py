"""The learner's files as they were when their work was judged.

Verdicts come from what programs do. The files help to find the cause, and are judged only if a file itself
is the exercise (a package.xml).
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path

MAX_FILE = 256 * 1024
MAX_TOTAL = 4 * 1024 * 1024
MAX_FILES = 500
MAX_DEPTH = 20
LEFT_OUT = frozenset({"__pycache__", "build", "install", "log", ".git", ".pytest_cache"})


@dataclass(frozen=True)
class Sources:
    """Text files by path relative to the course home; other files by name only.

    others: files that are not text or are too large to keep.
    """

    files: Mapping[str, str] = field(default_factory=dict)
    others: tuple[str, ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(sorted((*self.files, *self.others)))

    def below(self, folder: str) -> Sources:
        """Return only the files inside `folder`, still with paths relative to the course home."""
        prefix = folder.rstrip("/") + "/"
        return Sources(
            {name: text for name, text in self.files.items() if name.startswith(prefix)},
            tuple(name for name in self.others if name.startswith(prefix)),
        )


def read_sources(home: Path, roots: Iterable[str], *, trusted: bool = False) -> Sources:
    """Read the files and folders `roots` (relative to `home`), each file once, up to a limit.

    As in the build, a link counts as its target if that is in the course home. trusted: so does a root that
    is a link, or that is reached through one, wherever it leads.
    """
    files: dict[str, str] = {}
    others: list[str] = []
    total = 0
    inside = home.resolve()
    every = (entry for root in roots for entry in _at(home / root, inside, trusted=trusted))
    # Folders count, too, because links among them create endless paths.
    few = (path for path, is_folder in islice(every, 4 * MAX_FILES) if not is_folder)
    for path in islice(dict.fromkeys(few), MAX_FILES):
        name = name_in(home, path)
        text = _text(path) if total < MAX_TOTAL else None
        if text is None:
            others.append(name)
        else:
            files[name] = text
            total += len(text)
    return Sources(files, tuple(others))


def name_in(home: Path, path: Path) -> str:
    """A path in the home as valid text, even if its name is not valid UTF-8."""
    return os.fsencode(path.relative_to(home)).decode("utf-8", errors="replace")


def _at(root: Path, inside: Path, *, trusted: bool) -> Iterable[tuple[Path, bool]]:
    with contextlib.suppress(OSError, RuntimeError):  # RuntimeError: a loop of links
        if not trusted and not root.resolve().is_relative_to(inside):
            return ()
        if root.is_dir():
            return _below(root, inside, MAX_DEPTH)
        if root.is_file():
            return ((root, False),)
    return ()


def _below(folder: Path, inside: Path, depth: int) -> Iterator[tuple[Path, bool]]:
    """What is below a folder, and whether each is a folder: its own files before its subfolders, by name."""
    found = _entries(folder, inside)
    yield from ((path, False) for path, is_folder in found if not is_folder)
    for path, is_folder in found:
        if is_folder and depth > 1 and path.name not in LEFT_OUT:
            yield path, True
            yield from _below(path, inside, depth - 1)


def _entries(folder: Path, inside: Path) -> list[tuple[Path, bool]]:
    """A folder's entries, and whether each is a folder; leaves out links that lead outside."""
    try:
        with os.scandir(folder) as entries:
            few = list(islice(entries, 2 * MAX_FILES))
        return sorted((Path(e.path), e.is_dir()) for e in few if not leads_away(Path(e.path), inside))
    except OSError:
        return []


def leads_away(path: Path, inside: Path) -> bool:
    """Whether this link leads out of the course home, or up to a folder that contains it."""
    if not path.is_symlink():
        return False
    try:
        target = path.resolve()
    except (OSError, RuntimeError):  # a link to itself
        return True
    return not target.is_relative_to(inside) or path.parent.resolve().is_relative_to(target)


def _text(path: Path) -> str | None:
    """The file's text; None for a device, a large file or invalid UTF-8."""
    try:
        if not path.is_file() or path.stat().st_size > MAX_FILE:
            return None
        return path.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError):
        return None

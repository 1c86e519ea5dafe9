"""The learner's files as they were when their work was judged.

Verdicts come from what programs do; the files serve to say where the cause is, and where
a file itself is the exercise (a package.xml), to judge it.
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
_LEFT_OUT = frozenset({"__pycache__", "build", "install", "log", ".git", ".pytest_cache"})


@dataclass(frozen=True)
class Sources:
    """Text files by path relative to the course home; other files by name only.

    others: files that exist but are not text or too large to keep.
    """

    files: Mapping[str, str] = field(default_factory=dict)
    others: tuple[str, ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(sorted((*self.files, *self.others)))

    def below(self, folder: str) -> Sources:
        """The same files, only those inside `folder`, still named from the course home."""
        prefix = folder.rstrip("/") + "/"
        return Sources(
            {name: text for name, text in self.files.items() if name.startswith(prefix)},
            tuple(name for name in self.others if name.startswith(prefix)),
        )


def read_sources(home: Path, roots: Iterable[str]) -> Sources:
    """Read the files and folders `roots` (relative to `home`), each file once and not without end.

    As for the build, a link counts as what it leads to if that lies in the course home, and so does
    a root that is a link itself.
    """
    files: dict[str, str] = {}
    others: list[str] = []
    total = 0
    inside = home.resolve()
    every = (path for root in roots for path in _at(home / root, inside))
    for path in islice(dict.fromkeys(islice(every, 2 * MAX_FILES)), MAX_FILES):
        name = os.fsencode(path.relative_to(home)).decode("utf-8", errors="replace")
        text = _text(path) if total < MAX_TOTAL else None
        if text is None:
            others.append(name)
        else:
            files[name] = text
            total += len(text)
    return Sources(files, tuple(others))


def _at(root: Path, inside: Path) -> Iterable[Path]:
    with contextlib.suppress(OSError):
        if root.is_dir():
            return _below(root, inside, MAX_DEPTH)
        if root.is_file():
            return (root,)
    return ()


def _below(folder: Path, inside: Path, depth: int) -> Iterator[Path]:
    """Files below a folder, its own before those of folders in it, by name."""
    found = _entries(folder, inside)
    yield from (path for path, is_folder in found if not is_folder)
    for path, is_folder in found:
        if is_folder and depth > 1 and path.name not in _LEFT_OUT:
            yield from _below(path, inside, depth - 1)


def _entries(folder: Path, inside: Path) -> list[tuple[Path, bool]]:
    """What lies in a folder, and whether it is one itself; links that lead away are left out."""
    try:
        with os.scandir(folder) as entries:
            few = list(islice(entries, 2 * MAX_FILES))
        return sorted((Path(e.path), e.is_dir()) for e in few if not _leads_away(Path(e.path), inside))
    except OSError:
        return []


def _leads_away(path: Path, inside: Path) -> bool:
    """Whether this is a link out of the course home, or up to a folder that holds it."""
    if not path.is_symlink():
        return False
    try:
        target = path.resolve()
    except (OSError, RuntimeError):  # a link to itself
        return True
    return not target.is_relative_to(inside) or path.parent.resolve().is_relative_to(target)


def _text(path: Path) -> str | None:
    """The file's text; None for a device, something large or not UTF-8."""
    try:
        if not path.is_file() or path.stat().st_size > MAX_FILE:
            return None
        return path.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError):
        return None

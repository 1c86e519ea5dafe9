"""The learner's files as they were when their work was judged.

Verdicts come from what programs do; the files serve to say where the cause is, and where
a file itself is the exercise (a package.xml), to judge it.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

MAX_FILE = 256 * 1024
MAX_TOTAL = 4 * 1024 * 1024
MAX_FILES = 500
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
    """Read the files and folders `roots` (relative to `home`), bounded, following no symlink."""
    files: dict[str, str] = {}
    others: list[str] = []
    total = 0
    for path in _walk(home, roots):
        name = path.relative_to(home).as_posix()
        text = _text(path) if total < MAX_TOTAL else None
        if text is None:
            others.append(name)
        else:
            files[name] = text
            total += len(text)
    return Sources(files, tuple(others))


def _walk(home: Path, roots: Iterable[str]) -> list[Path]:
    found: list[Path] = []
    for root in roots:
        start = home / root
        if start.is_symlink():
            continue
        if start.is_file():
            found.append(start)
        for folder, folders, names in os.walk(start):
            folders[:] = sorted(set(folders) - _LEFT_OUT)
            found += [Path(folder, name) for name in sorted(names)]
            if len(found) > MAX_FILES:
                return found[:MAX_FILES]
    return found


def _text(path: Path) -> str | None:
    """The file's text; None for a symlink, a device, something large or not UTF-8."""
    try:
        if path.is_symlink() or not path.is_file() or path.stat().st_size > MAX_FILE:
            return None
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return None

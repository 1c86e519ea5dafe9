"""Which files make a package, and a copy of them.

What tools leave behind in a source folder is no part of it. A link within the course home counts as
what it leads to; one that leads out of it stays a link, so that nothing of the machine is copied.
"""

from __future__ import annotations

import os
import shutil
import stat
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

_LEFT_BY_TOOLS = frozenset(
    {"__pycache__", ".git", ".pytest_cache", ".mypy_cache", ".ruff_cache", ".vscode", ".idea", ".venv"}
)
# What `colcon build` leaves when it is run in the package's own folder.
_LEFT_BY_COLCON = frozenset({"build", "install", "log"})

# A package of a course has some dozen files. More is an environment or a recording gone astray, and
# hashing and copying it at every check would take longer than the check.
MOST_FILES = 5000
MOST_BYTES = 200_000_000


@dataclass(frozen=True)
class SourceFile:
    """`name` is relative to the package's folder; `link` is set for a link that is kept as one."""

    name: str
    path: Path
    size: int
    executable: bool
    link: str | None = None


class TooMuch(Exception):
    """The package's folder holds more than a package can; `largest` is the entry that weighs most."""

    def __init__(self, largest: str) -> None:
        super().__init__(largest)
        self.largest = largest


def source_files(folder: Path, home: Path) -> list[SourceFile]:
    """The files of the package in `folder`, sorted by name. Raises TooMuch."""
    found: list[SourceFile] = []
    total = 0
    for file in _walk(folder, "", home.resolve(), ()):
        found.append(file)
        total += file.size
        if len(found) > MOST_FILES or total > MOST_BYTES:
            raise TooMuch(_largest(found, by_size=total > MOST_BYTES))
    return sorted(found, key=lambda file: file.name)


def _largest(files: list[SourceFile], *, by_size: bool) -> str:
    weights: Counter[str] = Counter()
    for file in files:
        weights[file.name.split("/")[0]] += file.size if by_size else 1
    return weights.most_common(1)[0][0]


def copy_sources(folder: Path, home: Path, to: Path) -> None:
    """Copy the files of the package in `folder` to the new folder `to`."""
    to.mkdir(parents=True)
    for file in source_files(folder, home):
        target = to / file.name
        target.parent.mkdir(parents=True, exist_ok=True)
        if file.link is not None:
            target.symlink_to(file.link)
        else:
            shutil.copyfile(file.path, target)
            target.chmod(0o755 if file.executable else 0o644)


def _walk(folder: Path, prefix: str, home: Path, above: tuple[Path, ...]) -> Iterator[SourceFile]:
    with os.scandir(folder) as entries:
        for entry in entries:
            if entry.name in _LEFT_BY_TOOLS or (not prefix and entry.name in _LEFT_BY_COLCON):
                continue
            name = f"{prefix}{entry.name}"
            if entry.is_symlink():
                yield from _through_link(Path(entry.path), name, home, above)
            elif entry.is_dir():
                yield from _walk(Path(entry.path), f"{name}/", home, above)
            elif entry.is_file():  # pipes and sockets would hang whoever reads them
                yield _file(name, Path(entry.path), entry.stat())


def _through_link(path: Path, name: str, home: Path, above: tuple[Path, ...]) -> Iterator[SourceFile]:
    target = path.resolve()
    if not target.is_relative_to(home) or not target.exists():
        yield SourceFile(name, path, 0, False, str(path.readlink()))
    elif target.is_file():
        yield _file(name, target, target.stat())
    elif target.is_dir() and target not in above and not path.parent.resolve().is_relative_to(target):
        yield from _walk(target, f"{name}/", home, (*above, target))


def _file(name: str, path: Path, status: os.stat_result) -> SourceFile:
    return SourceFile(name, path, status.st_size, bool(status.st_mode & stat.S_IXUSR))

"""The files of a package, a copy of them, and the key of a build: the same for the same content.

What tools leave behind in a source folder does not belong to it. A link within the course home counts as
its target. One that leads out of it stays a link, so that nothing else on the machine is copied.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import stat
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

_LEFT_BY_TOOLS = frozenset(
    {"__pycache__", ".git", ".pytest_cache", ".mypy_cache", ".ruff_cache", ".vscode", ".idea", ".venv"}
)
# What `colcon build` leaves when it is run in the package's own folder.
_LEFT_BY_COLCON = frozenset({"build", "install", "log"})

# A package of a course has a few dozen files. Many more are a misplaced environment or recording, and
# hashing and copying them at every check would take longer than the check. Folders count, too.
MOST_FILES = 5000
MOST_BYTES = 200_000_000
MOST_DEPTH = 40
# Increased when builds of the same sources change, because of colcon's options or the layout of an entry.
_FORMAT = "1"


@dataclass(frozen=True)
class SourceFile:
    """`name` is relative to the package's folder; `link` is set for a link that is kept as one."""

    name: str
    path: Path
    size: int
    executable: bool
    link: str | None = None


class SourcesChanged(Exception):
    """What was copied is not what was hashed: someone saved a file in between."""


class TooMuch(Exception):
    """The package's folder contains more than a package can; `largest` is the largest thing in it."""

    def __init__(self, largest: str) -> None:
        super().__init__(largest)
        self.largest = largest


def source_files(folder: Path, home: Path) -> list[SourceFile]:
    """The files of the package in `folder`, sorted by name. Raises TooMuch."""
    found: list[SourceFile] = []
    number, total = 0, 0
    sizes: Counter[str] = Counter()
    numbers: Counter[str] = Counter()
    for name, file in _walk(folder, "", home.resolve(), ()):
        entry = name.split("/")[0]
        number, numbers[entry] = number + 1, numbers[entry] + 1
        if file:
            found.append(file)
            total, sizes[entry] = total + file.size, sizes[entry] + file.size
        if number > MOST_FILES or total > MOST_BYTES:
            weights = sizes if total > MOST_BYTES else numbers
            raise TooMuch(weights.most_common(1)[0][0])
    return sorted(found, key=lambda file: file.name)


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


def _walk(
    folder: Path, prefix: str, home: Path, above: tuple[Path, ...]
) -> Iterator[tuple[str, SourceFile | None]]:
    """The names of all files and folders, each with its SourceFile; None for a folder."""
    if prefix.count("/") > MOST_DEPTH:
        raise TooMuch(prefix.split("/")[0])
    with os.scandir(folder) as entries:
        for entry in entries:
            if entry.name in _LEFT_BY_TOOLS or (not prefix and entry.name in _LEFT_BY_COLCON):
                continue
            name = f"{prefix}{entry.name}"
            if entry.is_symlink():
                yield from _through_link(Path(entry.path), name, home, above)
            elif entry.is_dir():
                yield name, None
                yield from _walk(Path(entry.path), f"{name}/", home, above)
            elif entry.is_file():  # reading a pipe or a socket could hang
                yield name, _file(name, Path(entry.path), entry.stat())


def _through_link(
    path: Path, name: str, home: Path, above: tuple[Path, ...]
) -> Iterator[tuple[str, SourceFile | None]]:
    target = within(path, home)
    if target is None:
        yield name, SourceFile(name, path, 0, False, str(path.readlink()))
    elif target.is_file():
        yield name, _file(name, target, target.stat())
    elif target.is_dir() and target not in above and not path.parent.resolve().is_relative_to(target):
        yield name, None
        yield from _walk(target, f"{name}/", home, (*above, target))


def within(path: Path, folder: Path | None) -> Path | None:
    """What the path leads to, with all links followed; None if it does not exist, or is not in `folder`."""
    try:
        target = path.resolve(strict=True)
    except (OSError, RuntimeError):  # it leads nowhere, or in a circle
        return None
    return target if folder is None or target.is_relative_to(folder) else None


def _file(name: str, path: Path, status: os.stat_result) -> SourceFile:
    return SourceFile(name, path, status.st_size, bool(status.st_mode & stat.S_IXUSR))


def content_key(folder: Path, home: Path, dependencies: Iterable[str], identity: str) -> str:
    """32 hexadecimal digits that stand for one build of the package in `folder`.

    dependencies: keys of the workspace packages it depends on. identity: identifies the ROS in use.
    It covers the names, contents and executable bits of all source files. Raises TooMuch.
    """
    return _key((_FORMAT, identity, *sorted(dependencies)), source_files(folder, home), _content)


def likeness_key(
    folder: Path,
    home: Path,
    dependencies: Iterable[str],
    identity: str,
    may_differ: Callable[[SourceFile], bool],
) -> str:
    """A key that is the same for packages that differ only in the contents of files that may differ."""

    def content(file: SourceFile) -> bytes:
        return b"" if may_differ(file) else _content(file)

    return _key(("like", _FORMAT, identity, *sorted(dependencies)), source_files(folder, home), content)


def is_module(file: SourceFile) -> bool:
    """Whether the file is Python that a build copies, and does not run."""
    return file.link is None and file.name.endswith(".py") and file.name != "setup.py"


def _key(parts: Iterable[str], files: Iterable[SourceFile], content: Callable[[SourceFile], bytes]) -> str:
    digest = hashlib.blake2b(digest_size=16)
    for part in parts:
        digest.update(part.encode() + b"\0")
    for file in files:
        data = content(file)
        kind = "link" if file.link is not None else "executable" if file.executable else "file"
        digest.update(f"{file.name}\0{kind}\0{len(data)}\0".encode("utf-8", "surrogateescape") + data)
    return digest.hexdigest()


def _content(file: SourceFile) -> bytes:
    return file.path.read_bytes() if file.link is None else file.link.encode("utf-8", "surrogateescape")

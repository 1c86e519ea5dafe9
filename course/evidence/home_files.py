"""Files and folders of the course home as they were when the learner's work was judged.

This module has their names, kinds and modes; `Sources` has the texts. Checks use the view `Home`, so none
of them looks at a real disk.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from itertools import islice
from pathlib import Path, PurePosixPath
from typing import Literal

from course.content.layout import STATE
from course.evidence.sources import LEFT_OUT, MAX_DEPTH, MAX_FILES, Sources, leads_away, name_in
from course.spelling import close_names

Kind = Literal["file", "folder", "link", "other", "missing"]

_MAGIC = frozenset("*?[")
# `lamp_shop_script.py` and `lamp_shop_class.py` are 0.76 alike, but not a typo; in another folder,
# neither are `test_lamp_shop_class.py` and `_lamp_shop_class.py`, at 0.9.
_ALIKE = 0.85
_ALIKE_ELSEWHERE = 0.92
_SEPARATORS = str.maketrans("- ", "__")


@dataclass(frozen=True)
class HomeEntry:
    """One file or folder; `path` is relative to the course home.

    kind: "link" for one that leads out of the course home or nowhere; any other link counts as its target.
    mode: permission bits (0o755). size: bytes. target: where a link points. modified: when the content last
    changed, in seconds since 1970.
    """

    path: str
    kind: Kind
    mode: int = 0
    size: int = 0
    target: str | None = None
    modified: float = field(default=0.0, compare=False)


@dataclass(frozen=True)
class HomeFile:
    """What is at one path of the home; kind "missing" if nothing is.

    text: None if it is not a text file, or too large to keep.
    """

    path: str
    kind: Kind
    mode: int = 0
    size: int = 0
    target: str | None = None
    text: str | None = None

    @property
    def exists(self) -> bool:
        return self.kind != "missing"

    @property
    def is_file(self) -> bool:
        return self.kind == "file"

    @property
    def dos_line_ends(self) -> bool:
        """Whether its lines end as on Windows; `text` has normal line ends."""
        ends = (self.text or "").count("\n")
        return ends > 0 and self.size - len((self.text or "").encode()) >= ends

    @property
    def lines(self) -> tuple[str, ...]:
        """Its lines without line ends; empty if it has no text."""
        return tuple((self.text or "").splitlines())


@dataclass(frozen=True)
class Home:
    """The part of the course home that the exercise looks at."""

    entries: Mapping[str, HomeEntry] = field(default_factory=dict)
    texts: Mapping[str, str] = field(default_factory=dict)

    @classmethod
    def of(cls, entries: Iterable[HomeEntry], sources: Sources) -> Home:
        return cls({entry.path: entry for entry in entries}, sources.files)

    def file(self, path: str) -> HomeFile:
        """Return what is at `path`, relative to the home (`a_folder/an_empty_file.txt`)."""
        found = self.entries.get(path)
        if found is None:
            return HomeFile(path, "missing")
        text = self.texts.get(path) if found.kind == "file" else None
        return HomeFile(path, found.kind, found.mode, found.size, found.target, text)

    def inside(self, folder: str = "") -> tuple[str, ...]:
        """Names directly inside a folder of the home (by default, the home), if the exercise looks there."""
        paths = (PurePosixPath(path) for path in self.entries)
        return tuple(sorted(path.name for path in paths if path.parent == PurePosixPath(folder)))

    def near(self, path: str) -> tuple[str, ...]:
        """Files (for a folder's path, also folders) that the learner probably meant as this one, best first.

        First a similar name in the same folder, then the same name elsewhere, then a similar one elsewhere.
        """
        wanted = PurePosixPath(path)
        others = [PurePosixPath(p) for p, e in self.entries.items() if p != path and e.kind != "folder"]
        here = [other for other in others if other.parent == wanted.parent]
        away = [other for other in others if other.parent != wanted.parent]
        same = [other for other in away if other.name == wanted.name]
        found = (*_alike(wanted.name, here), *same, *_alike(wanted.name, away, _ALIKE_ELSEWHERE))
        return tuple(dict.fromkeys(str(other) for other in found))

    def near_folder(self, path: str) -> str | None:
        """A folder with a similar name, or with this name in another place."""
        return next(iter(self.near_folders(path)), None)

    def near_folders(self, path: str) -> tuple[str, ...]:
        """Folders that the learner probably meant as this one, best first."""
        wanted = PurePosixPath(path)
        folders = [PurePosixPath(p) for p, e in self.entries.items() if p != path and e.kind == "folder"]
        here = [folder for folder in folders if folder.parent == wanted.parent]
        found = (*_alike(wanted.name, here), *(folder for folder in folders if folder.name == wanted.name))
        return tuple(dict.fromkeys(map(str, found)))


def _alike(name: str, candidates: Iterable[PurePosixPath], cutoff: float = _ALIKE) -> list[PurePosixPath]:
    """Those whose names differ by a typo, the order of words, or an extra ending (`.txt.txt`)."""
    every = list(candidates)
    plain: dict[str, list[PurePosixPath]] = {}
    for candidate in every:
        plain.setdefault(_plain(candidate.name), []).append(candidate)
    close = close_names(_plain(name), plain, cutoff=cutoff)
    turned = {_in_order(key): key for key in plain}
    mixed = close_names(_in_order(_plain(name)), turned, cutoff=cutoff)
    stem = _plain(name).split(".")[0]
    same_stem = [key for key in plain if stem and key.split(".")[0] == stem]
    keys = dict.fromkeys((*close, *same_stem, *(turned[key] for key in mixed)))
    return [path for key in keys for path in plain[key]]


def _in_order(name: str) -> str:
    """The name with its words sorted: `class_lamp_tests.py` for `lamp_class_tests.py`."""
    stem, dot, rest = name.partition(".")
    return "_".join(sorted(filter(None, stem.split("_")))) + dot + rest


def _plain(name: str) -> str:
    return name.lower().translate(_SEPARATORS)


def read_entries(home: Path, patterns: Iterable[str]) -> tuple[HomeEntry, ...]:
    """Everything that `patterns` match in the course home, each once, in their order, up to a limit.

    A pattern is a file, a folder (with everything below it), or a name with `*`, `?` or `[...]` in any of
    its parts. Such a name means only what it matches. As in a shell, a leading `*` does not match a leading
    dot. What the course stores in the home for itself is never included.
    """
    inside = home.resolve()
    found = (path for pattern in patterns for path in _matches(home, pattern, inside))
    paths = islice(dict.fromkeys(islice(found, 4 * MAX_FILES)), 2 * MAX_FILES)
    return tuple(_entry(path, home, inside) for path in paths)


def _matches(home: Path, pattern: str, inside: Path) -> Iterator[Path]:
    parts = PurePosixPath(pattern).parts
    plain = not _MAGIC & set(pattern)
    for path in _walk(home, parts, inside):
        yield path
        if plain and _enters(path, inside):
            yield from _below(path, inside, MAX_DEPTH)


def _walk(folder: Path, parts: tuple[str, ...], inside: Path) -> Iterator[Path]:
    head, rest = parts[0], parts[1:]
    names = [head] if not _MAGIC & set(head) else [name for name in _names(folder) if _fits(name, head)]
    for path in (folder / name for name in names if name != STATE):
        if not os.path.lexists(path):
            continue
        if not rest:
            yield path
        elif _enters(path, inside):
            yield from _walk(path, rest, inside)


def _fits(name: str, pattern: str) -> bool:
    return fnmatchcase(name, pattern) and (not name.startswith(".") or pattern.startswith("."))


def _below(folder: Path, inside: Path, depth: int) -> Iterator[Path]:
    """Everything in a folder: its own entries first, then those of its subfolders."""
    paths = [folder / name for name in _names(folder) if name not in LEFT_OUT]
    yield from paths
    for path in paths:
        if depth > 1 and _enters(path, inside):
            yield from _below(path, inside, depth - 1)


def _names(folder: Path) -> list[str]:
    try:
        with os.scandir(folder) as entries:
            return sorted(entry.name for entry in islice(entries, 2 * MAX_FILES))
    except OSError:
        return []


def _enters(path: Path, inside: Path) -> bool:
    return path.is_dir() and not leads_away(path, inside)


def _entry(path: Path, home: Path, inside: Path) -> HomeEntry:
    name = name_in(home, path)
    try:
        target = str(path.readlink()) if path.is_symlink() else None
        if target is not None and (leads_away(path, inside) or not path.exists()):
            return HomeEntry(name, "link", target=target)
        found = path.stat()
    except OSError:  # it was just removed, or is not readable
        return HomeEntry(name, "other")
    mode = stat.S_IMODE(found.st_mode)
    return HomeEntry(name, _kind(found.st_mode), mode, found.st_size, target, found.st_mtime)


def _kind(mode: int) -> Kind:
    if stat.S_ISREG(mode):
        return "file"
    return "folder" if stat.S_ISDIR(mode) else "other"

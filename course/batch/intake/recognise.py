"""What a submission is: a course home, a workspace, packages or single files, however deeply wrapped.

Only names are looked at. Of two that could be meant, the one least deep is taken, then the first by name.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import takewhile
from pathlib import PurePosixPath

from course.batch.intake.model import Kind, Place
from course.batch.intake.tree import Tree
from course.content.layout import WORKSPACE

SRC = f"{WORKSPACE}/src"
_STATE = ".ros2course"
_RANK = (Kind.HOME, Kind.WORKSPACE, Kind.PACKAGES, Kind.FILES)


@dataclass(frozen=True)
class Root:
    """Something recognised at `path` of the tree."""

    kind: Kind
    path: str

    @property
    def order(self) -> tuple[int, int, str]:
        return _RANK.index(self.kind), self.path.count("/") + bool(self.path), self.path


def recognise(tree: Tree, known: Iterable[str]) -> tuple[Root, ...]:
    """All that is there, the best first. `known`: files of exercises, relative to a course home."""
    return tuple(sorted(_Names(tree, known).roots(), key=lambda root: root.order))


def sources_of_packages(known: Iterable[str]) -> Mapping[str, str]:
    """Where exercises have the packages that lie in no ordinary place: by name, the folder above."""
    parts = (PurePosixPath(path).parts for path in known)
    deep = [each for each in parts if len(each) > 3 and each[1] == "src" and each[0] != WORKSPACE]
    return {package: f"{workspace}/{src}" for workspace, src, package, *_ in deep}


def loose(paths: Iterable[str], known: Iterable[str]) -> tuple[tuple[Place, ...], tuple[str, ...]]:
    """Places for files that were handed in by themselves, and those that could belong to several.

    A file is told by its name and the folders that it lies in, as far as they were handed in too.
    Canvas writes `setup-1.py` for the second try at `setup.py`.
    """
    by_name: dict[str, set[str]] = {}
    for path in known:
        by_name.setdefault(PurePosixPath(path).name, set()).add(path)
    places: dict[str, str] = {}
    unclear = []
    for path in sorted(paths, key=lambda path: (-_try(path), path)):  # the latest first
        fitting = _fitting(path, by_name)
        if len(fitting) == 1:
            places.setdefault(fitting[0], path)
        elif fitting:
            unclear.append(path)
    return tuple(Place(source, target) for target, source in sorted(places.items())), tuple(unclear)


def _fitting(path: str, by_name: Mapping[str, Iterable[str]]) -> list[str]:
    """The known files that this one is most like: those with the most folders in common."""
    own = PurePosixPath(path).with_name(_name(path, by_name))
    alike = {other: _in_common(own, PurePosixPath(other)) for other in by_name.get(own.name, ())}
    return [other for other, count in alike.items() if count == max(alike.values())]


def _in_common(one: PurePosixPath, other: PurePosixPath) -> int:
    pairs = zip(reversed(one.parts), reversed(other.parts), strict=False)
    return sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], pairs))


def _name(path: str, known: Container[str]) -> str:
    name = PurePosixPath(path)
    earlier = f"{name.stem.rpartition('-')[0]}{name.suffix}"
    return earlier if _try(path) and earlier in known and name.name not in known else name.name


def _try(path: str) -> int:
    """2 for `setup-2.py`, 0 for `setup.py`."""
    number = PurePosixPath(path).stem.rpartition("-")[2]
    return int(number) if number.isdecimal() else 0


class _Names:
    def __init__(self, tree: Tree, known: Iterable[str]) -> None:
        self._files = tree.files()
        self._folders = tree.folders()
        self._packages = Packages(tree)
        self._outside = tuple(path for path in known if "/" in path and not path.startswith(f"{WORKSPACE}/"))
        self._below: dict[str, list[str]] = {}
        for folder in self._folders:
            self._below.setdefault(_parent(folder), []).append(folder)

    def roots(self, folder: str = "") -> Iterator[Root]:
        """What is recognised in a folder and below it; nothing inside of what was recognised."""
        if _join(folder, WORKSPACE) in self._folders or _join(folder, _STATE) in self._folders:
            yield Root(Kind.HOME, folder)
            return
        if any(_join(folder, path) in self._files for path in self._outside):
            yield Root(Kind.HOME, folder)  # with no workspace: there may be one of another name in it
        if self._packages.is_one(folder):
            yield Root(Kind.PACKAGES, folder)
        elif self._packages.below(_join(folder, "src")):
            yield Root(Kind.WORKSPACE, folder)
        else:
            for below in sorted(self._below.get(folder, ())):
                yield from self.roots(below)


class Packages:
    """The folders of a tree that have a package.xml."""

    def __init__(self, tree: Tree) -> None:
        self._below: dict[str, list[str]] = {}
        for path in sorted(tree.files()):
            if PurePosixPath(path).name == "package.xml":
                for above in and_above(_parent(path)):
                    self._below.setdefault(above, []).append(_parent(path))

    def is_one(self, folder: str) -> bool:
        return folder in self._below.get(folder, ())

    def below(self, folder: str) -> list[str]:
        """Those in `folder` and below it, sorted; one inside another is none."""
        found = self._below.get(folder, [])
        every = set(found)
        return sorted(each for each in found if each == folder or not self._within(each, folder, every))

    def _within(self, package: str, top: str, every: Container[str]) -> bool:
        above = takewhile(lambda each: each != top, and_above(_parent(package)))
        return any(each in every for each in (*above, top))


def and_above(path: str) -> Iterator[str]:
    """`a/b`, `a` and "" for `a/b`."""
    while path:
        yield path
        path = _parent(path)
    yield ""


def _parent(path: str) -> str:
    return path.rpartition("/")[0]


def _join(folder: str, name: str) -> str:
    return f"{folder}/{name}" if folder else name

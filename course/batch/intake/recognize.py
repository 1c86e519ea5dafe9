"""What a submission is, however deeply wrapped, and where its parts belong in a course home.

Of several candidates, it takes the one handed in last, then the one least deep, then the first by name.
"""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import takewhile
from pathlib import PurePosixPath

from course.batch.intake.submission import Placement, SubmissionKind
from course.batch.intake.tree import Tree, TreeEntry, content
from course.content.layout import STATE, WORKSPACE
from course.explain.package_xml import name_in
from course.home.opening import Refused, Remark, visible
from course.model import replace

SRC = f"{WORKSPACE}/src"
_RANK = (SubmissionKind.HOME, SubmissionKind.WORKSPACE, SubmissionKind.PACKAGES, SubmissionKind.FILES)


@dataclass(frozen=True)
class Root:
    """Something recognized at `path` of the tree."""

    kind: SubmissionKind
    path: str

    def order(self, tree: Tree) -> tuple[int, int, int, str]:
        depth = self.path.count("/") + bool(self.path)
        return _RANK.index(self.kind), _age(tree, self.path), depth, self.path


def roots_in(tree: Tree, known: Iterable[str]) -> tuple[Root, ...]:
    """All roots in the tree, the best first. `known`: files of exercises, relative to a course home."""
    return tuple(sorted(_Names(tree, known).roots(), key=lambda root: root.order(tree)))


def _age(tree: Tree, path: str) -> int:
    """0 for a file in the newest of several parts, more for older ones."""
    top = path.partition("/")[0]
    return tree.parts.index(top) if top in tree.parts else 0


def sources_of_packages(known: Iterable[str]) -> Mapping[str, str]:
    """The packages that exercises keep in an unusual place: by name, the folder above each."""
    parts = (PurePosixPath(path).parts for path in known)
    deep = [each for each in parts if len(each) > 3 and each[1] == "src" and each[0] != WORKSPACE]
    return {package: f"{workspace}/{src}" for workspace, src, package, *_ in deep}


def loose(paths: Iterable[str], known: Iterable[str]) -> tuple[tuple[Placement, ...], tuple[str, ...]]:
    """Places for files that were handed in by themselves, and the files that fit several places.

    A file is recognized by its name, and by its folders if they were handed in, too. Otherwise, it goes
    into the package of files beside it that have only one place.
    Canvas writes `setup-1.py` for the second try at `setup.py`.
    """
    by_name: dict[str, set[str]] = {}
    for path in known:
        by_name.setdefault(PurePosixPath(path).name, set()).add(path)
    places: dict[str, str] = {}
    unclear = []
    latest_first = sorted(paths, key=lambda path: (-number_of_try(path), path))
    fits = {path: fitting for path in latest_first if (fitting := _fitting(path, by_name))}
    packages = tuple({_package_of(only) for only, *others in fits.values() if not others})
    for path, fitting in fits.items():
        near = [target for target in fitting if len(fitting) == 1 or target.startswith(packages)]
        if len(near) == 1:
            places.setdefault(near[0], path)
        else:
            unclear.append(path)
    return tuple(Placement(source, target) for target, source in sorted(places.items())), tuple(unclear)


def _fitting(path: str, by_name: Mapping[str, Iterable[str]]) -> list[str]:
    """The known files that have the most folders in common with this one."""
    own = PurePosixPath(path).with_name(_name(path, by_name))
    alike = {other: _in_common(own, PurePosixPath(other)) for other in by_name.get(own.name, ())}
    return [other for other, count in alike.items() if count == max(alike.values())]


def _package_of(path: str) -> str:
    return "/".join((*path.split("/")[:3], ""))


def _in_common(one: PurePosixPath, other: PurePosixPath) -> int:
    pairs = zip(reversed(one.parts), reversed(other.parts), strict=False)
    return sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], pairs))


def _name(path: str, known: Container[str]) -> str:
    name = PurePosixPath(path)
    earlier = f"{name.stem.rpartition('-')[0]}{name.suffix}"
    return earlier if number_of_try(path) and earlier in known and name.name not in known else name.name


def number_of_try(path: str) -> int:
    """2 for `setup-2.py`, 0 for `setup.py`."""
    number = PurePosixPath(path).name.partition(".")[0].rpartition("-")[2]
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
        """What is recognized in a folder and below it, but not inside what was recognized."""
        if _join(folder, WORKSPACE) in self._folders or _join(folder, STATE) in self._folders:
            yield Root(SubmissionKind.HOME, folder)
            return
        if any(_join(folder, path) in self._files for path in self._outside):
            # It has no workspace, but there may be one with another name in it.
            yield Root(SubmissionKind.HOME, folder)
        if self._packages.is_one(folder):
            yield Root(SubmissionKind.PACKAGES, folder)
        elif self._packages.below(_join(folder, "src")):
            yield Root(SubmissionKind.WORKSPACE, folder)
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
        """Those in `folder` and below it, sorted; one inside another one does not count."""
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


_PACKAGE = re.compile(r"[A-Za-z0-9][\w-]{0,99}", re.ASCII)
LARGEST_MANIFEST = 100_000  # bytes
_MOST_PACKAGES = 1000

OTHERS = "It contains more than one course home. Used: {}. The others were left out."
TWICE = "It contains a package more than once. Used: {}. The others were left out."
FLAT = "Its files were handed in without their folders, and were put where they belong."
UNCLEAR = "Files that could belong to several packages were left out."


@dataclass(frozen=True)
class Recognized:
    """The fields of `Found` that depend only on names of files."""

    kind: SubmissionKind
    root: str
    packages: tuple[str, ...]
    places: tuple[Placement, ...]
    findings: tuple[Remark, ...]
    written: tuple[tuple[str, bytes], ...] = ()


_NOTHING = Recognized(SubmissionKind.NOTHING, "", (), (), ())


def recognize(tree: Tree, known: Iterable[str]) -> Recognized:
    """known: files of exercises, relative to a course home. Raises Refused if there are too many packages."""
    if sum(path.rpartition("/")[2] == "package.xml" for path in tree.files()) > _MOST_PACKAGES:
        what = f"It contains more than {_MOST_PACKAGES:,} packages."
        raise Refused(what, "Ask for only the packages of the course.")
    known = tuple(known)
    roots = roots_in(tree, known)
    planned = _Recognizing(tree, roots, known).recognized() if roots else _NOTHING
    if planned.kind is SubmissionKind.HOME:
        return planned  # in a course home, learners must put misplaced files right themselves
    tops = {root.path for root in roots}
    beside = [path for path in tree.files() if tops.isdisjoint(and_above(path))]
    places, unclear = loose(beside, known)
    findings = planned.findings
    if unclear and not roots:
        where = ", ".join(visible(path) for path in unclear[:3])
        findings = (Remark(UNCLEAR, "Ask for the whole package, with its package.xml.", where), *findings)
    kind = SubmissionKind.FILES if places and not roots else planned.kind
    return replace(planned, kind=kind, places=planned.places + places, findings=findings)


def made_of(tree: Tree, places: Iterable[Placement]) -> Iterable[tuple[str, TreeEntry]]:
    """Everything that has a place: its path in the course home, and its entry.

    If two belong at the same path, it is the first place's.
    """
    targets: dict[str, list[tuple[int, str]]] = {}
    left_out = set()
    for rank, place in enumerate(places):
        if place.target is None:
            left_out.add(place.source)
        else:
            targets.setdefault(place.source, []).append((rank, place.target))
    made: dict[str, tuple[int, TreeEntry]] = {}
    for path, entry in tree.entries.items():
        if left_out and not left_out.isdisjoint(and_above(path)):
            continue
        for source in and_above(path):
            for rank, target in targets.get(source, ()):
                at = "/".join(filter(None, (target, path.removeprefix(source).lstrip("/"))))
                if at and (at not in made or rank < made[at][0]):
                    made[at] = rank, entry
    return [(at, entry) for at, (_, entry) in made.items()]


class _Recognizing:
    """The best root is taken as it is; packages that it lacks are added from the others."""

    def __init__(self, tree: Tree, roots: tuple[Root, ...], known: tuple[str, ...]) -> None:
        self._tree = tree
        self._known = known
        self._sources = sources_of_packages(known)
        self._roots = roots
        self._found = Packages(tree)
        self._places: list[Placement] = []
        self._packages: dict[str, str] = {}  # by name: the folder of each
        self._findings: list[Remark] = []

    def recognized(self) -> Recognized:
        best = self._roots[0]
        whole = [root for root in self._whole() if root.kind is not SubmissionKind.PACKAGES]
        for root in whole:
            self._places.append(Placement(root.path, "" if root.kind is SubmissionKind.HOME else WORKSPACE))
            names = {folder: _package_name(self._tree, folder) for folder in self._packages_in(root)}
            self._packages.update((name, folder) for folder, name in names.items())
            if root.kind is SubmissionKind.WORKSPACE:
                self._places += [
                    Placement(folder, f"{self._sources[name]}/{name}")
                    for folder, name in names.items()
                    if name in self._sources
                ]
        homes = [root.path for root in self._roots if root.kind is SubmissionKind.HOME]
        others = [folder for root in self._roots if root not in whole for folder in self._packages_in(root)]
        self._add(others, told={*homes[1:]})
        if len(homes) > 1:
            taken, *others = (visible(home or ".") for home in homes[:4])
            self._findings.append(Remark(OTHERS.format(f"`{taken}`"), where=", ".join(others)))
        packages = tuple(sorted(self._packages))
        written = self._unfolded() if best.kind is SubmissionKind.PACKAGES else ()
        several = best.kind is SubmissionKind.PACKAGES and len(self._roots) > 1
        path = "" if several else best.path
        return Recognized(best.kind, path, packages, tuple(self._places), tuple(self._findings), written)

    def _unfolded(self) -> tuple[tuple[str, bytes], ...]:
        """Move files beside a package.xml to where the course has them: upload forms take no folders.

        Returns the empty files that such a Python package needs.
        """
        files, written = self._tree.files(), []
        for name, folder in self._packages.items():
            place = f"{self._sources.get(name, SRC)}/{name}"
            moved = self._moved(name, folder, place)
            if moved:
                self._findings.append(Remark(FLAT, where=name))
                # Before the folder as a whole, because the first place counts.
                self._places[:0] = [Placement(each, f"{place}/{to}") for each, to in moved.items()]
                # A file with the package's name belongs in `resource`, and is empty.
                self._places += [Placement(each, None) for each in files if each == _join(folder, name)]
                taken = {*files, *(_join(folder, to) for to in moved.values())}
                empty = (f"{name}/__init__.py", f"resource/{name}") if _is_python(name, moved) else ()
                written += [
                    (f"{place}/{each}", b"")
                    for each in empty
                    if taken.isdisjoint((_join(folder, each), _join(folder, "resource")))
                ]
        return tuple(written)

    def _moved(self, name: str, folder: str, place: str) -> dict[str, str]:
        """For each misplaced file beside a package.xml: the path in the package where it is missing."""
        files = self._tree.files()
        inside = [path.removeprefix(f"{place}/") for path in self._known if path.startswith(f"{place}/")]
        at = {"setup.py": "setup.py", **{PurePosixPath(path).name: path for path in inside}}
        beside = sorted((each for each in files if _parent(each) == folder), key=number_of_try, reverse=True)
        known = {each: at[_name(each, at)] for each in beside if _name(each, at) in at}
        moved = {each: to for each, to in known.items() if _join(folder, to) not in files}
        if _is_python(name, moved):
            modules = (each for each in beside if each.endswith(".py") and each not in known)
            moved |= {each: f"{name}/{PurePosixPath(each).name}" for each in modules}
        return moved

    def _whole(self) -> Iterator[Root]:
        """The best root. For a home without a workspace, also the best workspace."""
        best = self._roots[0]
        yield best
        has_workspace = f"{best.path}/{WORKSPACE}".lstrip("/") in self._tree.entries
        if best.kind is SubmissionKind.HOME and not has_workspace:
            yield from [root for root in self._roots if root.kind is SubmissionKind.WORKSPACE][:1]

    def _packages_in(self, root: Root) -> list[str]:
        if root.kind is SubmissionKind.PACKAGES:
            return [root.path]
        if root.kind is SubmissionKind.WORKSPACE:
            return self._found.below(root.path)
        sources = (WORKSPACE, *sorted(set(self._sources.values())))
        return [folder for source in sources for folder in self._found.below(_join(root.path, source))]

    def _add(self, folders: Iterable[str], told: set[str]) -> None:
        """told: homes that another remark reports as left out."""
        twice: dict[str, str] = {}
        for folder in folders:
            name = _package_name(self._tree, folder)
            before = self._packages.get(name)
            if before is not None and _age(self._tree, folder) >= _age(self._tree, before):
                twice[folder] = name
                continue
            if before is not None:
                twice[before] = name
                self._places.append(Placement(before, None))
            self._packages[name] = folder
            self._places.append(Placement(folder, f"{self._sources.get(name, SRC)}/{name}"))
        twice = {folder: name for folder, name in twice.items() if told.isdisjoint(and_above(folder))}
        if twice:
            where = ", ".join(map(visible, list(twice)[:3]))
            taken = dict.fromkeys(f"`{visible(self._packages[name])}`" for name in list(twice.values())[:3])
            self._findings.append(Remark(TWICE.format(" and ".join(taken)), where=where))


def _is_python(name: str, moved: Mapping[str, str]) -> bool:
    return any(to.startswith(f"{name}/") for to in moved.values())


def _package_name(tree: Tree, folder: str) -> str:
    """From its package.xml, so that a wrapper such as `repo-main` does not matter."""
    entry = tree.entries[f"{folder}/package.xml".lstrip("/")]
    data = content(replace(entry, size=min(entry.size, LARGEST_MANIFEST))) or b""
    own = folder.rpartition("/")[2]
    return next((each for each in (name_in(data) or "", own) if _PACKAGE.fullmatch(each)), "package")

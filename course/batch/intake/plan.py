"""Where the parts of a submission belong in a course home."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from xml.etree import ElementTree

from course.batch.intake.model import Kind, Place
from course.batch.intake.recognise import (
    SRC,
    Packages,
    Root,
    and_above,
    loose,
    recognise,
    sources_of_packages,
)
from course.batch.intake.tree import Entry, Tree
from course.build.manifest import guessed_name
from course.content.layout import WORKSPACE
from course.home.opening import Finding, visible

_PACKAGE = re.compile(r"[A-Za-z0-9][\w-]{0,99}", re.ASCII)
_LARGEST_MANIFEST = 100_000  # bytes

OTHERS = "It holds more than one course home; one was taken, the others were left out."
TWICE = "A package is there more than once; one was taken, the others were left out."
UNCLEAR = "Files that could belong to several packages were left out."


@dataclass(frozen=True)
class Plan:
    """The fields of `Found` that the names of the files decide."""

    kind: Kind
    root: str
    packages: tuple[str, ...]
    places: tuple[Place, ...]
    findings: tuple[Finding, ...]


_NOTHING = Plan(Kind.NOTHING, "", (), (), ())


def plan(tree: Tree, known: Iterable[str]) -> Plan:
    """known: files of exercises, relative to a course home."""
    known = tuple(known)
    roots = recognise(tree, known)
    planned = _Planning(tree, roots, sources_of_packages(known)).plan() if roots else _NOTHING
    if planned.kind is Kind.HOME:
        return planned  # what is misplaced in a home is the learner's to put right
    tops = {root.path for root in roots}
    beside = [path for path in tree.files() if tops.isdisjoint(and_above(path))]
    places, unclear = loose(beside, known)
    findings = planned.findings
    if unclear and not roots:
        where = ", ".join(visible(path) for path in unclear[:3])
        findings = (Finding(UNCLEAR, "Ask for the whole package, with its package.xml.", where), *findings)
    kind = Kind.FILES if places and not roots else planned.kind
    return replace(planned, kind=kind, places=planned.places + places, findings=findings)


def made_of(tree: Tree, places: Iterable[Place]) -> Iterable[tuple[str, Entry]]:
    """Path in the course home, and entry, for all that has a place.

    Where two belong to the same path, it is the first place's.
    """
    targets: dict[str, list[tuple[int, str]]] = {}
    for rank, place in enumerate(places):
        targets.setdefault(place.source, []).append((rank, place.target))
    made: dict[str, tuple[int, Entry]] = {}
    for path, entry in tree.entries.items():
        for source in and_above(path):
            for rank, target in targets.get(source, ()):
                at = "/".join(filter(None, (target, path.removeprefix(source).lstrip("/"))))
                if at and (at not in made or rank < made[at][0]):
                    made[at] = rank, entry
    return [(at, entry) for at, (_, entry) in made.items()]


class _Planning:
    """The best root is laid as it is; of the others, packages that it lacks are added."""

    def __init__(self, tree: Tree, roots: tuple[Root, ...], sources: Mapping[str, str]) -> None:
        self._tree = tree
        self._sources = sources
        self._roots = roots
        self._found = Packages(tree)
        self._places: list[Place] = []
        self._packages: set[str] = set()
        self._findings: list[Finding] = []

    def plan(self) -> Plan:
        best = self._roots[0]
        whole = [root for root in self._whole() if root.kind is not Kind.PACKAGES]
        for root in whole:
            self._places.append(Place(root.path, "" if root.kind is Kind.HOME else WORKSPACE))
            names = {folder: _package_name(self._tree, folder) for folder in self._packages_in(root)}
            self._packages.update(names.values())
            if root.kind is Kind.WORKSPACE:
                self._places += [
                    Place(folder, f"{self._sources[name]}/{name}")
                    for folder, name in names.items()
                    if name in self._sources
                ]
        self._add(folder for root in self._roots if root not in whole for folder in self._packages_in(root))
        homes = [root for root in self._roots if root.kind is Kind.HOME]
        if len(homes) > 1:
            paths = ", ".join(visible(home.path or ".") for home in homes[:4])
            self._findings.append(Finding(OTHERS, "The first of these is graded.", paths))
        packages = tuple(sorted(self._packages))
        several = best.kind is Kind.PACKAGES and len(self._roots) > 1
        path = "" if several else best.path
        return Plan(best.kind, path, packages, tuple(self._places), tuple(self._findings))

    def _whole(self) -> Iterator[Root]:
        """The best root; for a home without a workspace, the best workspace too."""
        best = self._roots[0]
        yield best
        has_workspace = f"{best.path}/{WORKSPACE}".lstrip("/") in self._tree.entries
        if best.kind is Kind.HOME and not has_workspace:
            yield from [root for root in self._roots if root.kind is Kind.WORKSPACE][:1]

    def _packages_in(self, root: Root) -> list[str]:
        if root.kind is Kind.PACKAGES:
            return [root.path]
        sources = (SRC, *sorted(set(self._sources.values()))) if root.kind is Kind.HOME else ("src",)
        return [
            folder for source in sources for folder in self._found.below(f"{root.path}/{source}".lstrip("/"))
        ]

    def _add(self, folders: Iterable[str]) -> None:
        twice = []
        for folder in folders:
            name = _package_name(self._tree, folder)
            if name in self._packages:
                twice.append(folder)
            else:
                self._packages.add(name)
                self._places.append(Place(folder, f"{self._sources.get(name, SRC)}/{name}"))
        if twice:
            where = ", ".join(visible(folder) for folder in twice[:3])
            self._findings.append(Finding(TWICE, "Left out are the ones named here.", where))


def _package_name(tree: Tree, folder: str) -> str:
    """As its package.xml says, so that a wrapper such as `repo-main` does not matter."""
    entry = tree.entries[f"{folder}/package.xml".lstrip("/")]
    with entry.path.open("rb") as file:
        data = file.read(_LARGEST_MANIFEST)
    try:  # its conditions are not evaluated: only the name counts here
        name = (ElementTree.fromstring(data).findtext("name") or "").strip()
    except (ElementTree.ParseError, LookupError, ValueError):  # the latter: encodings that do not exist
        name = guessed_name(data) or ""
    own = folder.rpartition("/")[2]
    return next((each for each in (name, own) if _PACKAGE.fullmatch(each)), "package")

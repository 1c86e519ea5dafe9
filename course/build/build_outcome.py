"""How a build ends, and what can be wrong before anything is built.

Packages may be missing or duplicated, need each other in a circle, or have a bad package.xml.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

from course.build.package_sources import MOST_BYTES, MOST_FILES, within
from course.build.workspace import IGNORE_MARKERS, Package, Workspace, read_package, shown
from course.explain.package_xml import ManifestFault
from course.model.feedback import Feedback, Location
from course.spelling import LOOSELY, nearest

_NOT_SEARCHED = frozenset({"build", "install", "log", "node_modules", "site-packages"})
# The most folders to search for a misplaced package; the most packages of a circle to name.
_MOST_SEARCHED, _MOST_SHOWN = 2000, 6
_DEEPEST = 6  # levels below the course home; misplaced packages are not deeper than this
Found = tuple[tuple[Location, ...], str]


@dataclass(frozen=True)
class InstalledPackage:
    """One package that is ready to be used.

    source: its folder, relative to the course home, as the learner knows it.
    prefix: its install prefix, made for this content alone, and never written to again.
    cached: whether it had been built before. seconds: how long this build took; 0 if cached.
    """

    name: str
    source: str
    prefix: Path
    cached: bool
    seconds: float


@dataclass(frozen=True)
class BuildFailure:
    """A package that cannot be built as it is, and why. It is always the learner's to repair.

    kind: a short stable word for the cause ("package-missing", "setup-py", "cmake-syntax", ...).
    log: everything the build printed, if it ran at all.
    """

    package: str
    kind: str
    feedback: Feedback
    log: Path | None = None


@dataclass(frozen=True)
class BuildOutcome:
    """All that was asked for and its dependencies, dependencies first, as far as the build got."""

    packages: tuple[InstalledPackage, ...]
    failure: BuildFailure | None
    seconds: float

    @property
    def prefixes(self) -> tuple[Path, ...]:
        """Install prefixes, dependencies first: the last one goes on top."""
        return tuple(package.prefix for package in self.packages)


def package_missing(workspace: Workspace, name: str) -> BuildFailure:
    """There is no package of that name where packages belong."""
    summary = f"There is no package `{name}` in {workspace.source}."
    where, advice = (
        _leads_out(workspace, name)
        or _astray(workspace, name)
        or _look_alike(workspace, name)
        or ((), _make_it(workspace))
    )
    found = tuple(f"{package.source}: {package.name}" for package in workspace.packages)
    return BuildFailure(
        name, "package-missing", Feedback(summary, where=where, advice=advice, details=found[:6])
    )


def duplicate(packages: Sequence[Package]) -> BuildFailure:
    name = packages[0].name
    summary = f"There are {len(packages)} packages called `{name}`; colcon refuses to build any of them."
    where = tuple(manifest_place(package, "name") for package in packages)
    advice = "Rename or remove all but one; keep copies outside the workspace."
    return BuildFailure(name, "package-twice", Feedback(summary, where=where, advice=advice))


def cycle(workspace: Workspace, names: Sequence[str]) -> BuildFailure:
    shown = names if len(names) <= _MOST_SHOWN else (*names[:_MOST_SHOWN], "...")
    circle = " needs ".join(f"`{name}`" for name in (*shown, names[0]))
    where = tuple(
        Location(f"{package.source}/package.xml", dependency.line)
        for name, needed in zip(names, (*names[1:], names[0]), strict=True)
        for package in workspace.named(name)
        for dependency in package.dependencies
        if dependency.name == needed
    )[:_MOST_SHOWN]
    advice = "Remove one of these dependencies: none of the packages can be built before the other."
    return BuildFailure(names[0], "package-circle", Feedback(f"{circle}.", where=where, advice=advice))


def unreadable(package: Package, fault: ManifestFault) -> BuildFailure:
    file = f"{package.source}/package.xml"
    summary = f"package.xml of `{package.name}` is not right: {fault.what}."
    details = _line(package.folder / "package.xml", fault.line)
    feedback = Feedback(summary, where=(Location(file, fault.line),), advice=fault.advice, details=details)
    return BuildFailure(package.name, "package-xml", feedback)


_IGNORED = "`colcon build` ignores {} because of {}: delete that file."


def too_much(package: Package, largest: str) -> BuildFailure:
    summary = f"The folder of `{package.name}` contains more than a package may: look at `{largest}`."
    advice = (
        f"Move it out of the package: more than {MOST_FILES} files or {MOST_BYTES // 10**6} MB are not built."
    )
    where = (Location(f"{package.source}/{largest}"),)
    return BuildFailure(package.name, "package-size", Feedback(summary, where=where, advice=advice))


def too_many(package: Package, number: int, most: float) -> BuildFailure:
    summary = f"This exercise needs {number} packages, its own included, and at most {most:g} are built."
    advice = "Remove the dependencies that the exercise does not ask for from package.xml."
    where = (Location(f"{package.source}/package.xml"),)
    return BuildFailure(package.name, "packages-limit", Feedback(summary, where=where, advice=advice))


def crowded(workspace: Workspace, most: int) -> BuildFailure:
    summary = f"{workspace.source} contains more than {most} packages, so they are not read."
    advice = "Move those that do not belong to the course out of the workspace."
    feedback = Feedback(summary, where=(Location(workspace.source),), advice=advice)
    return BuildFailure("", "packages-limit", feedback)


def manifest_place(package: Package, tag: str) -> Location:
    line = package.manifest.lines.get(tag) if package.manifest else None
    return Location(f"{package.source}/package.xml", line)


def _leads_out(workspace: Workspace, name: str) -> Found | None:
    """It may be behind a link out of the course home. Such links are not followed."""
    source = workspace.root / "src"
    for place in (workspace.root, source, source / name):
        if place.is_symlink() and within(place, workspace.inside) is None:
            file = shown(place, workspace.home)
            return (Location(file),), f"{file} is a link out of the course home: replace it with the folder."
    return None


def _astray(workspace: Workspace, name: str) -> Found | None:
    """The package or its folder exists, but not as a package of the workspace."""
    for folder in islice(_folders(workspace.home), _MOST_SEARCHED):
        place = shown(folder, workspace.home)
        if (folder / "package.xml").is_file():
            if read_package(folder, workspace.home, workspace.inside).name == name:
                if marker := _marker(workspace, folder):
                    return (Location(marker),), _IGNORED.format(place, marker)
                inside = _inside(workspace, folder)
                return (Location(place),), f"It is in {place}{inside}: move it to {workspace.source}/{name}."
        elif folder.name == name and any(
            (folder / file).is_file() for file in ("setup.py", "CMakeLists.txt")
        ):
            what = f"The folder {place} has no package.xml. Without one, it is not a package."
            return (Location(place),), what
    return None


def _marker(workspace: Workspace, folder: Path) -> str | None:
    """The file that keeps colcon from looking into the folder."""
    above = (one for one in (folder, *folder.parents) if one.is_relative_to(workspace.root))
    marked = (one / name for one in above for name in sorted(IGNORE_MARKERS))
    return next((shown(file, workspace.home) for file in marked if file.exists()), None)


def _inside(workspace: Workspace, folder: Path) -> str:
    outer = [package.name for package in workspace.packages if folder.is_relative_to(package.folder)]
    return f", inside the package `{outer[0]}`" if outer else ""


def _look_alike(workspace: Workspace, name: str) -> Found | None:
    names = {package.name: package for package in workspace.packages}
    folders = {package.folder.name: package for package in workspace.packages}
    if package := folders.get(name):
        advice = f"The package in {package.source} calls itself `{package.name}`: correct its `<name>`."
        return (
            manifest_place(package, "name"),
        ), f"{advice} The names in setup.py or CMakeLists.txt must agree."
    if near := nearest(name, names, LOOSELY):
        advice = f"Did you mean `{near}`? Its folder, its `<name>` in package.xml and setup.py must say so."
        return (manifest_place(names[near], "name"),), advice
    return None


def _make_it(workspace: Workspace) -> str:
    return f"Create it with `ros2 pkg create`, in the folder {workspace.source}."


def _folders(top: Path) -> Iterator[Path]:
    for folder, folders, _ in os.walk(top):
        depth = len(Path(folder).relative_to(top).parts)
        stop = depth >= _DEEPEST
        folders[:] = [] if stop else sorted(n for n in folders if n not in _NOT_SEARCHED and n[0] != ".")
        yield Path(folder)


def _line(file: Path, number: int | None) -> tuple[str, ...]:
    if number is None:  # then the file may be unreadable
        return ()
    lines = file.read_text(encoding="utf-8", errors="replace").splitlines()
    return (lines[number - 1].strip(),) if number <= len(lines) else ()

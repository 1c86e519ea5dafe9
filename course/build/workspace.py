"""The packages of a workspace, found the way colcon finds them."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import islice
from pathlib import Path

from course.build.package_sources import MOST_DEPTH, within
from course.explain.package_xml import Dependency, Manifest, ManifestFault, guessed_name, read_manifest

IGNORE_MARKERS = frozenset({"COLCON_IGNORE", "AMENT_IGNORE", "CATKIN_IGNORE"})
_INTERFACES = "rosidl_interface_packages"
_COLCON_FOLDERS = frozenset({"build", "install", "log"})
# A package.xml of a course has about a thousand bytes, and a workspace a few dozen folders.
_MOST_BYTES = 256 * 1024
_MOST_FOLDERS = 20_000
# The most that are used. One more is read, to notice that there are too many.
MOST_PACKAGES = 200
_MANIFEST_IS_SHORT = "It is a short file: compare it with the one in another package."


@dataclass(frozen=True)
class Package:
    """One package in the workspace.

    folder: its path. source: the same, relative to the course home.
    manifest: None if package.xml cannot be read; then `fault` says why, and `name` is the best guess.
    """

    name: str
    folder: Path
    source: str
    manifest: Manifest | None
    fault: ManifestFault | None = None

    @property
    def build_type(self) -> str:
        """As colcon sees it: a package.xml that does not state one is for the older catkin."""
        return (self.manifest.build_type if self.manifest else None) or "catkin"

    @property
    def dependencies(self) -> tuple[Dependency, ...]:
        """What package.xml declares for building and running, in its order."""
        return self.manifest.dependencies if self.manifest else ()

    @property
    def has_interfaces(self) -> bool:
        """Whether it makes messages, services or actions."""
        return self.manifest is not None and _INTERFACES in self.manifest.groups

    def depends_on(self, name: str) -> bool:
        """Whether package.xml declares a dependency on `name` for building or running."""
        return any(dependency.name == name for dependency in self.dependencies)


@dataclass(frozen=True)
class Workspace:
    """The packages below `root`: mostly in its src, but colcon looks everywhere.

    home: the course home; messages show paths relative to it. inside: see `read_package`.
    """

    root: Path
    home: Path
    packages: tuple[Package, ...]
    inside: Path | None = None

    @classmethod
    def scan(cls, root: Path, home: Path | None = None, *, trusted: bool = False) -> Workspace:
        """Find the packages of the workspace `root`; `home` is the folder above it if not given.

        A workspace that does not exist is not an error: it has no packages. trusted: packages, and the
        workspace itself, may be links out of the home, because some people keep them in a repository;
        otherwise, such links are not followed.
        """
        home = home or root.parent
        inside = None if trusted else home.resolve()
        folders = islice(package_folders(root, inside), MOST_PACKAGES + 1)
        return cls(root, home, tuple(read_package(folder, home, inside) for folder in folders), inside)

    def scan_again(self) -> Workspace:
        """The same workspace as it is now."""
        return Workspace.scan(self.root, self.home, trusted=self.is_trusted)

    @property
    def is_trusted(self) -> bool:
        """Whether it is the learner's own or the course's, and not a submission."""
        return self.inside is None

    @property
    def source(self) -> str:
        """Where packages belong, relative to the course home."""
        return shown(self.root / "src", self.home)

    def named(self, name: str) -> tuple[Package, ...]:
        """All packages of that name: one, none, or the same name twice."""
        return self._by_name.get(name, ())

    @cached_property
    def _by_name(self) -> dict[str, tuple[Package, ...]]:
        found: dict[str, tuple[Package, ...]] = {}
        for package in self.packages:
            found[package.name] = (*found.get(package.name, ()), package)
        return found

    def find(self, name: str) -> Package | None:
        """The package of that name, if there is exactly one."""
        found = self.named(name)
        return found[0] if len(found) == 1 else None


def read_package(folder: Path, home: Path, inside: Path | None) -> Package:
    """inside: the folder, with all links followed, out of which links must not lead; None if they may."""
    data = _manifest_bytes(folder / "package.xml", inside)
    read = data if isinstance(data, ManifestFault) else read_manifest(data)
    if isinstance(read, ManifestFault):
        guessed = guessed_name(data) if isinstance(data, bytes) else None
        return Package(guessed or folder.name, folder, shown(folder, home), None, read)
    return Package(read.name, folder, shown(folder, home), read)


def _manifest_bytes(file: Path, inside: Path | None) -> bytes | ManifestFault:
    """Read only a plain file, so that a pipe cannot block."""
    advice = "Replace it with a plain text file."
    target = within(file, inside)
    if target is None:
        return ManifestFault("it is a link to a place outside the course home, or to nothing", None, advice)
    descriptor = os.open(target, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
    with os.fdopen(descriptor, "rb") as opened:
        status = os.fstat(descriptor)
        if not stat.S_ISREG(status.st_mode):
            return ManifestFault("it is not a plain file", None, advice)
        if status.st_size > _MOST_BYTES:
            return ManifestFault(f"it has more than {_MOST_BYTES // 1024} KiB", None, _MANIFEST_IS_SHORT)
        return opened.read()


def package_folders(top: Path, inside: Path | None) -> Iterator[Path]:
    """Folders with a package.xml below `top`, sorted. As for colcon, a package inside another does not count.

    inside: see `read_package`.
    """
    seen: set[Path] = set()
    if within(top, inside) is None:
        return
    for name, folders, files in os.walk(top, followlinks=True):
        folder = Path(name)
        if IGNORE_MARKERS.intersection(files) or len(seen) > _MOST_FOLDERS:
            folders.clear()
        elif "package.xml" in files:
            folders.clear()
            yield folder
        else:
            deep = len(folder.parts) - len(top.parts) >= MOST_DEPTH
            folders[:] = (
                [] if deep else sorted(each for each in folders if _enters(folder / each, inside, seen))
            )


def _enters(folder: Path, inside: Path | None, seen: set[Path]) -> bool:
    """Links could form a circle. Like colcon, enter each folder once."""
    if folder.name.startswith(".") or folder.name in _COLCON_FOLDERS:
        return False
    target = within(folder, inside)
    if target is None or target in seen or folder.parent.resolve().is_relative_to(target):
        return False
    seen.add(target)
    return True


def shown(path: Path, home: Path) -> str:
    """A path as the learner knows it: relative to the course home if it is in there."""
    return path.relative_to(home).as_posix() if path.is_relative_to(home) else str(path)

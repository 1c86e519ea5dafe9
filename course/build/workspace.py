"""The packages of a workspace, found the way colcon finds them."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from course.build.manifest import Dependency, Manifest, ManifestFault, guessed_name, read_manifest

_IGNORE_MARKERS = frozenset({"COLCON_IGNORE", "AMENT_IGNORE", "CATKIN_IGNORE"})
_COLCON_FOLDERS = frozenset({"build", "install", "log"})


@dataclass(frozen=True)
class Package:
    """One package in the workspace.

    folder: where it lies; source: the same, relative to the course home.
    manifest: None when package.xml cannot be read; then `fault` says why, and `name` is the best guess.
    """

    name: str
    folder: Path
    source: str
    manifest: Manifest | None
    fault: ManifestFault | None = None

    @property
    def build_type(self) -> str:
        """As colcon takes it: a package.xml that does not say is one of the older catkin."""
        return (self.manifest.build_type if self.manifest else None) or "catkin"

    @property
    def dependencies(self) -> tuple[Dependency, ...]:
        """What package.xml declares for building and running, in its order."""
        return self.manifest.dependencies if self.manifest else ()

    def depends_on(self, name: str) -> bool:
        """Whether package.xml declares a dependency on `name` for building or running."""
        return any(dependency.name == name for dependency in self.dependencies)


@dataclass(frozen=True)
class Workspace:
    """The packages below `root`/src. `home` is the course home, which places are shown relative to."""

    root: Path
    home: Path
    packages: tuple[Package, ...]

    @classmethod
    def scan(cls, root: Path, home: Path | None = None) -> Workspace:
        """Find the packages of the workspace `root`; `home` is the folder above it if not given.

        Nothing is wrong with a workspace that is not there: it has no packages.
        """
        home = home or root.parent
        folders = package_folders(root / "src")
        return cls(root, home, tuple(read_package(folder, home) for folder in folders))

    @property
    def source(self) -> str:
        """Where packages belong, relative to the course home."""
        return shown(self.root / "src", self.home)

    def named(self, name: str) -> tuple[Package, ...]:
        """All packages of that name: one, none, or the same name twice."""
        return tuple(package for package in self.packages if package.name == name)

    def find(self, name: str) -> Package | None:
        """The package of that name, if it is there once."""
        found = self.named(name)
        return found[0] if len(found) == 1 else None


def read_package(folder: Path, home: Path) -> Package:
    data = (folder / "package.xml").read_bytes()
    read = read_manifest(data)
    if isinstance(read, ManifestFault):
        return Package(guessed_name(data) or folder.name, folder, shown(folder, home), None, read)
    return Package(read.name, folder, shown(folder, home), read)


def package_folders(top: Path) -> Iterator[Path]:
    """Folders with a package.xml below `top`, sorted. A package inside a package is not one, says colcon."""
    for folder, folders, files in os.walk(top, followlinks=True):
        if _IGNORE_MARKERS.intersection(files):
            folders.clear()
        elif "package.xml" in files:
            folders.clear()
            yield Path(folder)
        else:
            # A link back up would never end; colcon, too, takes each folder once.
            folders[:] = sorted(name for name in folders if _enters(Path(folder, name)))


def _enters(folder: Path) -> bool:
    hidden = folder.name.startswith(".")
    leads_back_up = folder.is_symlink() and folder.parent.resolve().is_relative_to(folder.resolve())
    return not hidden and folder.name not in _COLCON_FOLDERS and not leads_back_up


def shown(path: Path, home: Path) -> str:
    """A path as the learner knows it: relative to the course home if it lies there."""
    return path.relative_to(home).as_posix() if path.is_relative_to(home) else str(path)

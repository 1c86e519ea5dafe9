"""Which files of the machine a submission's programs can read: those on a list, and no others.

system          what the distribution's packages contain; see `SYSTEM`
environments    the Pythons and the ROS wheels: the usual folders of each prefix, and the Python packages
                that programs and builds of ROS packages need (`_PACKAGES`)
ROS             an installed one, its workspaces, and what builds of this submission installed
ours            the underlay's packages, and two programs that run alongside the learner's

A course can be installed like any Python package. Its folders, including the engine's, are not on the list.
"""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import sys
import time
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import course
from course.files import new_folder, wipe
from course.rosenv import Ros, places_of
from course.rosenv.ros import digest
from course.rosenv.variables import PREFIXES

# Shown as the system. /usr/src, /usr/games, and other folders below /usr/local may contain anything.
_BELOW = ("bin", "sbin", "lib", "lib32", "lib64", "libx32", "libexec", "include")
_LOCAL = Path("/usr/local")
SYSTEM = tuple(
    Path(name)
    for name in (
        *(f"/usr/{name}" for name in (*_BELOW, "share")),
        *(f"/{name}" for name in ("bin", "sbin", "lib", "lib32", "lib64", "libx32")),
    )
)
# In an environment's prefix. The last ones are the C library of conda's compilers, and our own files.
_OF_A_PREFIX = (*_BELOW, "pyvenv.cfg", "*-conda-linux-gnu", "setup.*", "local_setup.*")
# Besides those of ROS: packages that it does not register, and where CMake and pkg-config look.
_SHARED = frozenset("ament_index ros2course colcon foonathan_memory pkgconfig aclocal man locale".split())
_SHARED_BEGINNINGS = ("cmake", "colcon_", "fast")
_PYTHON_FOLDERS = ("lib*/python3*/site-packages", "lib*/python3*/dist-packages")
# Where a course may be installed among the distribution's packages.
_OF_THE_SYSTEM = (Path("/usr/share"), *(path for name in _PYTHON_FOLDERS for path in Path("/usr").glob(name)))
_STEM = re.compile("[-.]")
_LIBRARIES = ("LD_LIBRARY_PATH", "PKG_CONFIG_PATH")
# Python packages besides those of ROS: for nodes, for builds, and what these two import.
_PACKAGES = frozenset(
    """
    numpy dqrobotics yaml _yaml pyyaml PyYAML psutil typing_extensions six
    setuptools _distutils_hack distutils pkg_resources wheel pip em empy emlib lark lark_parser
    catkin_pkg docutils dateutil python_dateutil pyparsing packaging argcomplete importlib_metadata zipp
    importlib_resources ros_wheels_bootstrapper colcon distlib
    pytest _pytest py pluggy iniconfig pygments tomli exceptiongroup attr attrs ruff
    osrf_pycommon lxml netifaces
    scipy cv2 opencv_python opencv_python_headless matplotlib mpl_toolkits pylab contourpy cycler fontTools
    fonttools kiwisolver PIL pillow transforms3d
    """.split()
)
# Seconds after which links that nobody has used are removed.
_UNUSED = 7 * 86400.0
_OURS = (Path(course.__file__).parent / "arena/probe_program.py",)


@dataclass(frozen=True)
class View:
    """shown: files and folders that can be read, under their own paths.

    empty: folders in them that show only what is also in `shown`. linked: folders, each with the one that is
    shown in its place, see `linked`.
    """

    shown: tuple[str, ...] = ()
    empty: tuple[str, ...] = ()
    linked: tuple[tuple[str, str], ...] = ()

    def shows(self, path: Path) -> bool:
        """Whether this file can be read: the nearest folder around it decides."""
        around = map(str, (path, *path.parents))
        near = next((place for place in around if place in (*self.shown, *self.empty)), None)
        return near in self.shown or (near is None and any(path.is_relative_to(place) for place in SYSTEM))


def view(ros: Ros, environment: Mapping[str, str], more: Iterable[Path] = ()) -> View:
    """What programs with this `environment` (see `node_environment`) need, plus `more`."""
    environments = _environments(ros)
    folders = {prefix: _python_folders(prefix) for prefix in environments}
    named = [path for name in PREFIXES for path in _named(environment, name)]
    libraries = [path for name in _LIBRARIES for path in _named(environment, name)]
    private = (*environments, *(path.parent for path in _OURS))
    others = (
        *(path for path in (*named, *places_of(ros), *_OURS, *more) if path not in environments),
        *(path for path in libraries if not any(place.is_relative_to(path) for place in private)),
    )
    parts = [part for prefix in environments for part in _parts(prefix)]
    empty = [*(folder for found in folders.values() for folder in found), *_courses_of_the_system()]
    shown = _outermost([*_with_targets(others), *parts], empty)
    within = [folder for folder in empty if any(folder.is_relative_to(path) for path in (*SYSTEM, *shown))]
    read = {
        *sys.path,
        *(str(folder) for prefix in (ros.prefix, _LOCAL) for folder in folders.get(prefix, ())),
    }
    packages = [
        package
        for prefix in environments
        for folder in map(str, folders[prefix])
        if folder in read
        for package in _packages(folder, _registered(prefix))
    ]
    return View((*map(str, shown), *packages), tuple(map(str, within)))


def linked(seen: View, cache: Path) -> View:
    """Show one folder with hard links in `cache` in place of each folder of packages, where that is possible.

    bubblewrap reads the list of all mounts for each new one: 240 take 140 ms of CPU, and 80 take 28 ms.
    """
    packages = {
        folder: [path for path in dict.fromkeys(seen.shown) if Path(path).is_relative_to(folder)]
        for folder in seen.empty
    }
    found = {folder: _links(folder, packages[folder], cache) for folder in seen.empty if packages[folder]}
    folders = {folder: str(links) for folder, links in found.items() if links}
    inside = {path for folder in folders for path in packages[folder]}
    return View(
        tuple(path for path in seen.shown if path not in inside),
        tuple(folder for folder in seen.empty if folder not in folders),
        tuple(folders.items()),
    )


def _links(folder: str, packages: Sequence[str], cache: Path) -> Path | None:
    """The folder with the links; None if they cannot be made, as on another file system."""
    with contextlib.suppress(OSError):
        links = cache / digest([folder, *map(_stamp, packages)])
        if not links.exists():
            _remove_unused(cache)
            with contextlib.suppress(OSError):  # somebody else made the same ones first
                _link(Path(folder), packages, links)
        os.utime(links)
        return links
    return None


def _stamp(path: str) -> str:
    """A text that changes when pip replaces the package."""
    status = os.lstat(path)
    return f"{path} {status.st_ino} {status.st_mtime_ns}"


def _remove_unused(cache: Path) -> None:
    for old in cache.glob("*"):
        if old.stat().st_mtime < time.time() - _UNUSED:
            wipe(old)


def _link(folder: Path, packages: Sequence[str], target: Path) -> None:
    with new_folder(target) as links:
        for package in map(Path, packages):
            link = links / package.relative_to(folder)
            link.parent.mkdir(parents=True, exist_ok=True)
            for place in link.relative_to(links).parents:
                (links / place).chmod(0o755)
            if package.is_symlink() or package.is_file():
                os.link(package, link, follow_symlinks=False)
            else:
                shutil.copytree(package, link, symlinks=True, copy_function=os.link)


def _named(environment: Mapping[str, str], name: str) -> Iterator[Path]:
    return (Path(entry) for entry in environment.get(name, "").split(":") if entry.startswith("/"))


def _with_targets(paths: Iterable[Path]) -> list[Path]:
    """A link needs its target, too."""
    everything = dict.fromkeys(place for path in paths for place in (path, path.resolve()))
    return [path for path in everything if path.exists()]


def _environments(ros: Ros) -> list[Path]:
    """Prefixes in which packages of all kinds may be installed."""
    pythons = [Path(name) for name in (sys.prefix, sys.exec_prefix, sys.base_prefix, sys.base_exec_prefix)]
    own = [ros.prefix] if (ros.prefix / "bin/python3").exists() else []
    return [path for path in _with_targets([*pythons, *own, _LOCAL]) if path not in (Path("/"), Path("/usr"))]


def _python_folders(prefix: Path) -> list[Path]:
    """The folders of a prefix in which Python packages are installed, each by one name only."""
    real = prefix.resolve()
    found = sorted(folder for pattern in _PYTHON_FOLDERS for folder in prefix.glob(pattern))
    return [folder for folder in found if folder.resolve() == real / folder.relative_to(prefix)]


def _courses_of_the_system() -> list[Path]:
    """Courses that somebody installed among the distribution's packages."""
    folders = (folder for folder in _OF_THE_SYSTEM if folder.is_dir())
    return [path for folder in folders for path in folder.iterdir() if _holds_course(path)]


def _holds_course(folder: Path) -> bool:
    return any((folder / name).is_dir() for name in ("chapters", "_course/chapters"))


def _parts(prefix: Path) -> Iterator[Path]:
    for pattern in _OF_A_PREFIX:
        yield from prefix.glob(pattern)
    share, registered = prefix / "share", _registered(prefix)
    children = list(share.iterdir()) if share.is_dir() else []
    wanted = [child for child in children if _is_shared(child, registered)]
    yield from [share] if wanted == children else wanted


def _is_shared(child: Path, registered: Container[str]) -> bool:
    known = child.name in registered or child.name in _SHARED or child.name.startswith(_SHARED_BEGINNINGS)
    return known or (child / "cmake").is_dir()


def _registered(prefix: Path) -> frozenset[str]:
    """Names of the ROS packages in this prefix."""
    index = prefix / "share/ament_index/resource_index/packages"
    return frozenset(entry.name for entry in index.iterdir()) if index.is_dir() else frozenset()


def _packages(folder: str, registered: Container[str]) -> Iterator[str]:
    """What ROS needs from this folder of Python packages."""
    with os.scandir(folder) as entries:
        return (entry.path for entry in list(entries) if _is_package(entry, registered))


def _is_package(entry: os.DirEntry[str], registered: Container[str]) -> bool:
    name, stem = entry.name, _STEM.split(entry.name)[0]
    known = stem in _PACKAGES or stem.startswith("colcon_")
    if name.endswith("-info"):  # lists the programs and plugins that the package offers
        return (known or stem in registered) and Path(entry, "entry_points.txt").exists()
    if stem in registered:
        return Path(entry, "__init__.py").exists()
    return (known and not name.endswith("-stubs")) or (stem.startswith("ros_") and name.endswith(".libs"))


def _outermost(paths: Iterable[Path], empty: Iterable[Path]) -> list[Path]:
    """The paths, without those that a folder around them shows anyway, unless that folder is empty."""
    full, hollow = {*SYSTEM}, {*empty}
    kept: list[Path] = []
    for path in sorted(set(paths), key=lambda path: (len(path.parts), path)):
        around = next((place for place in path.parents if place in hollow or place in full), None)
        whole_system = path in SYSTEM or Path("/usr").is_relative_to(path)
        if not whole_system and around not in full - hollow:
            kept.append(path)
            full.add(path)
    return kept

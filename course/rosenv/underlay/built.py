"""Puts what was compiled into the prefix, in place of its stand-ins."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from course.rosenv.underlay.links import link
from course.rosenv.underlay.prefix import STANDINS

# Folders that packages share; whatever else lies in an install prefix belongs to its package alone.
_PROGRAMS = ("bin", "include", "lib", "lib/python3*", "lib/python3*/site-packages")
_SHARED = (*_PROGRAMS, "share", "share/*", "share/ament_index/*", "share/ament_index/resource_index/*")
# What lies right here serves `built` alone: colcon's setup files, and its notes.
_ALONE = (Path(), Path("share/colcon-core"))


def add_build(prefix: Path, built: Path) -> None:
    """Link everything of the install prefix `built` into `prefix`.

    What others wait for comes last, so that whoever finds the package finds all of it.
    """
    for part in sorted(_parts(built, Path()), key=_is_awaited):
        link(prefix / part, built / part)


def is_built(prefix: Path, package: str) -> bool:
    """Whether `package` is there itself, and not what stands in for it."""
    found = (prefix / "share" / package / "cmake").resolve()
    return found.is_dir() and not found.is_relative_to((prefix / STANDINS).resolve())


def _parts(built: Path, folder: Path) -> Iterator[Path]:
    """What is to be linked as a whole, relative to `built`."""
    for entry in sorted((built / folder).iterdir()):
        part = folder / entry.name
        if entry.is_dir() and not entry.is_symlink() and _is_shared(part):
            yield from _parts(built, part)
        elif folder not in _ALONE:
            yield part


def _is_shared(part: Path) -> bool:
    depth = len(part.parts) - 1
    return any(part.match(pattern) for pattern in _SHARED if pattern.count("/") == depth)


def _is_awaited(part: Path) -> bool:
    return part.name == "cmake" or "site-packages" in part.parts

"""C++ libraries of the system that packages use: whether they are there, as CMake would find them."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from course.errors import MissingHere

SYSTEM = (Path("/usr"), Path("/usr/local"))
_CMAKE_FOLDERS = ("share/*/cmake", "share/cmake/*", "lib/cmake/*", "lib/*/cmake/*")
# What CMake calls them, or how the names of their parts begin; what people do; the Debian package.
_LIBRARIES = {"Eigen3": ("Eigen 3", "libeigen3-dev"), "Qt5": ("Qt 5", "qtbase5-dev")}


def lacks_library(name: str, system: Iterable[Path] = SYSTEM) -> bool:
    """Whether CMake would not find the library of this name below these prefixes."""
    # Where Qt is there, one of its parts that is not is a name that somebody misspelt.
    main = "Qt5Core" if name.startswith("Qt5") else name
    places = [f"{folder}/{main}Config.cmake" for folder in _CMAKE_FOLDERS]
    return not any(any(root.glob(place)) for place in places for root in system)


def missing_library(name: str) -> MissingHere:
    """What to say where it is not there; `name` is Eigen3, or one of Qt 5's parts."""
    called, package = next(said for start, said in _LIBRARIES.items() if name.startswith(start))
    what = f"The C++ library {called} is not installed on this machine."
    return MissingHere(what, f"sudo apt install {package}")


def require_libraries(names: Iterable[str], system: Iterable[Path] = SYSTEM) -> None:
    """Raise MissingHere, with the command that installs it, for the first one that is not there."""
    for name in names:
        if lacks_library(name, system):
            raise missing_library(name)

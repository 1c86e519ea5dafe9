"""Facts about this machine: its Python, whether pip can install ROS 2 on it, its C++ libraries."""

from __future__ import annotations

import os
import shutil
import sys
import sysconfig
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from course.errors import MissingHere


@dataclass(frozen=True)
class Host:
    """The machine and the interpreter; `prefix` and `site_packages` are where pip puts the ROS wheels.

    `libc` is for example "glibc 2.36"; it is empty if there is no glibc (musl).
    """

    executable: Path
    prefix: Path
    site_packages: Path
    python: tuple[int, int]
    implementation: str = "cpython"
    free_threaded: bool = False
    system: str = "linux"
    machine: str = "x86_64"
    libc: str = "glibc 2.36"
    installed: Path = Path("/opt/ros/jazzy")

    @classmethod
    def here(cls) -> Host:
        """The machine and the interpreter that run this."""
        prefix, site_packages = _pip_places()
        return cls(
            executable=Path(sys.executable),
            prefix=prefix,
            site_packages=site_packages,
            python=sys.version_info[:2],
            implementation=sys.implementation.name,
            free_threaded="t" in getattr(sys, "abiflags", ""),
            system=sys.platform,
            machine=os.uname().machine if sys.maxsize > 2**32 else "32-bit",
            libc=_libc(),
        )

    @property
    def python_version(self) -> str:
        """For example "3.12"."""
        return f"{self.python[0]}.{self.python[1]}"


def _pip_places() -> tuple[Path, Path]:
    """Prefix and site-packages, with links resolved: a folder must have the same name in every cache key."""
    if sys.prefix != sys.base_prefix:
        # A virtual environment, the usual case: no need to load all of sysconfig's variables.
        prefix = Path(sys.prefix).resolve()
        return prefix, prefix / "lib" / f"python{sys.version_info[0]}.{sys.version_info[1]}" / "site-packages"
    return Path(sysconfig.get_path("data")).resolve(), Path(sysconfig.get_path("purelib")).resolve()


def _libc() -> str:
    try:
        return os.confstr("CS_GNU_LIBC_VERSION") or ""
    except (AttributeError, ValueError, OSError):
        return ""  # another C library cannot answer this


OLDEST, NEWEST = (3, 10), (3, 14)
_GLIBC = (2, 28)
_PACKAGES = (
    "Install ROS 2 Jazzy from its packages (Ubuntu 24.04, https://docs.ros.org/en/jazzy/Installation.html) "
    "or use the Docker image ros:jazzy. There, run: source /opt/ros/jazzy/setup.bash"
)
_PYTHON = (
    f"Set the course up with one of Python {OLDEST[0]}.{OLDEST[1]} to {NEWEST[0]}.{NEWEST[1]}, "
    "for example, in the course's folder: python3.12 -m venv .venv && .venv/bin/pip install '.[jazzy]'"
)


def why_no_wheels(host: Host) -> MissingHere | None:
    """Why pip cannot install ROS 2 on this machine, with advice; None if it can."""
    return _bad_machine(host) or _bad_libc(host) or _bad_python(host)


def _bad_machine(host: Host) -> MissingHere | None:
    if host.system != "linux":
        return MissingHere(f"ROS 2 from pip exists for Linux only; this is {host.system}.", _PACKAGES)
    if host.machine not in ("x86_64", "AMD64"):
        what = f"ROS 2 from pip exists for x86-64 processors only; this one is {host.machine}."
        return MissingHere(what, _PACKAGES)
    return None


def _bad_libc(host: Host) -> MissingHere | None:
    if not host.libc.startswith("glibc "):
        what = "ROS 2 from pip needs the C library glibc; this system has another, such as Alpine's musl."
        return MissingHere(what, _PACKAGES)
    numbers = tuple(int(part) for part in host.libc.split()[1].split(".")[:2])
    if numbers < _GLIBC:
        return MissingHere(f"ROS 2 from pip needs glibc 2.28 or newer, not {host.libc}.", _PACKAGES)
    return None


def _bad_python(host: Host) -> MissingHere | None:
    if host.implementation != "cpython" or host.free_threaded:
        kind = "free-threaded" if host.free_threaded else host.implementation
        return MissingHere(f"ROS 2 from pip needs the usual CPython; this Python is {kind}.", _PYTHON)
    if OLDEST <= host.python <= NEWEST:
        return None
    age = "old" if host.python < OLDEST else "new"
    return MissingHere(f"Python {host.python_version} is too {age} for ROS 2 from pip.", _PYTHON)


SYSTEM = (Path("/usr"), Path("/usr/local"))
_CMAKE_FOLDERS = ("share/*/cmake", "share/cmake/*", "lib/cmake/*", "lib/*/cmake/*")
# The library's name in CMake (or how its parts' names begin), its usual name, and its Debian package.
_LIBRARIES = {"Eigen3": ("Eigen 3", "libeigen3-dev"), "Qt5": ("Qt 5", "qtbase5-dev")}


def lacks_library(name: str, system: Iterable[Path] = SYSTEM) -> bool:
    """Whether CMake would not find the library with this name below these prefixes."""
    # If Qt itself is installed, a missing part of it is a misspelled name.
    main = "Qt5Core" if name.startswith("Qt5") else name
    places = [f"{folder}/{main}Config.cmake" for folder in _CMAKE_FOLDERS]
    return not any(any(root.glob(place)) for place in places for root in system)


def missing_library(name: str) -> MissingHere:
    """The error for a missing library; `name` is Eigen3, or one of Qt 5's parts."""
    called, package = next(said for start, said in _LIBRARIES.items() if name.startswith(start))
    what = f"The C++ library {called} is not installed on this machine."
    return MissingHere(what, f"sudo apt install {package}")


def require_libraries(names: Iterable[str], system: Iterable[Path] = SYSTEM) -> None:
    """Raise MissingHere for the first library that is missing, with the command that installs it."""
    for name in names:
        if lacks_library(name, system):
            raise missing_library(name)


_DEBIAN = {"cc": "gcc", "c++": "g++"}  # Debian packages whose names are not the tool's


def require(tools: Iterable[str], path: str, what: str = "This exercise") -> None:
    """Raise MissingHere, with the command that installs them, if any of these tools is not on this PATH."""
    missing = [tool for tool in tools if shutil.which(tool, path=path) is None]
    if missing:
        names = " and ".join(missing) if len(missing) < 3 else f"{', '.join(missing[:-1])}, and {missing[-1]}"
        packages = " ".join(_DEBIAN.get(tool, tool) for tool in missing)
        raise MissingHere(f"{what} needs {names}, which this machine lacks.", f"sudo apt install {packages}")

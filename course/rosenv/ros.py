"""Which ROS 2 the course uses: the value that is passed between the engine's packages."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

Origin = Literal["sourced", "installed", "pip"]


@dataclass(frozen=True)
class Ros:
    """A ROS 2 for which nodes can be built and run.

    `origin` says how it was found: "sourced" in the environment, "installed" below /opt/ros, or "pip" wheels.
    `prefix` is the folder whose share/ament_index lists rclpy, `python` the interpreter for its nodes.
    `identity` is a short hexadecimal text that changes whenever the ROS packages, their place or the Python
    change: do not use anything that was built or cached for another identity.
    `underlay` does the same for our own packages on top of pip wheels. Both date from when it was found.
    `notes` are sentences for `doctor`: everything works, but someone should know about them.
    """

    origin: Origin
    distro: str
    prefix: Path
    python: Path
    identity: str
    site_packages: Path | None = None
    notes: tuple[str, ...] = ()
    underlay: str = ""

    @property
    def python_packages(self) -> Path:
        """The folder that rclpy is imported from."""
        return self.site_packages or next(iter(python_folders(self.prefix)), self.prefix)


# Debian's Python puts packages of ament_cmake into dist-packages, some of them below local/.
_PYTHON_FOLDERS = (
    "lib/python3*/site-packages",
    "lib/python3*/dist-packages",
    "local/lib/python3*/dist-packages",
)


def python_folders(prefix: Path) -> tuple[Path, ...]:
    """The existing folders of `prefix` from which Python packages are imported."""
    return tuple(folder for pattern in _PYTHON_FOLDERS for folder in sorted(prefix.glob(pattern)))


# ROS itself, and other packages that affect what a build produces.
_WHEELS = ("ros_", "numpy-", "setuptools-", "empy-", "lark-", "catkin_pkg-", "colcon_")


def identity_of_wheels(prefix: Path, site_packages: Path, underlay: str = "") -> str:
    """Fingerprint of the wheels: names with versions, and when pip installed each (a reinstall counts).

    underlay: a fingerprint of our own packages, which are compiled on top of them.
    """
    with os.scandir(site_packages) as entries:
        wheels = sorted(
            f"{entry.name} {entry.stat().st_mtime_ns}"
            for entry in entries
            if entry.name.startswith(_WHEELS) and entry.name.endswith(".dist-info")
        )
    return digest([str(prefix), str(site_packages), underlay, *wheels])


def identity_of_prefixes(prefixes: Sequence[Path], python: str) -> str:
    """Fingerprint of installed packages: their names, and the times of their package.xml."""
    return digest([python, *(line for prefix in prefixes for line in _packages(prefix))])


def _packages(prefix: Path) -> Iterable[str]:
    yield str(prefix)
    with suppress(FileNotFoundError, NotADirectoryError):
        for entry in sorted((prefix / "share/ament_index/resource_index/packages").iterdir()):
            with suppress(FileNotFoundError):
                yield f"{entry.name} {(prefix / 'share' / entry.name / 'package.xml').stat().st_mtime_ns}"


def digest(lines: Iterable[str]) -> str:
    """A hash of these lines: 16 hexadecimal digits."""
    return hashlib.sha256("\n".join(lines).encode(errors="surrogateescape")).hexdigest()[:16]

"""A short fingerprint of a ROS 2: cheap enough for every command, different as soon as a ROS package is."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable, Sequence
from contextlib import suppress
from pathlib import Path

# Besides ROS itself: what takes part in building a package, and so shapes the result.
_WHEELS = ("ros_", "numpy-", "setuptools-", "empy-", "lark-", "catkin_pkg-", "colcon_")


def of_wheels(prefix: Path, site_packages: Path, underlay: str = "") -> str:
    """Fingerprint of the wheels: names with versions, and when pip put each there (a reinstall counts).

    underlay: stands for the packages of our own that are compiled on top of them.
    """
    with os.scandir(site_packages) as entries:
        wheels = sorted(
            f"{entry.name} {entry.stat().st_mtime_ns}"
            for entry in entries
            if entry.name.startswith(_WHEELS) and entry.name.endswith(".dist-info")
        )
    return digest([str(prefix), str(site_packages), underlay, *wheels])


def of_prefixes(prefixes: Sequence[Path], python: str) -> str:
    """Fingerprint of installed packages: their names, and the times of their package.xml."""
    return digest([python, *(line for prefix in prefixes for line in _packages(prefix))])


def _packages(prefix: Path) -> Iterable[str]:
    yield str(prefix)
    with suppress(FileNotFoundError, NotADirectoryError):
        for entry in sorted((prefix / "share/ament_index/resource_index/packages").iterdir()):
            with suppress(FileNotFoundError):
                yield f"{entry.name} {(prefix / 'share' / entry.name / 'package.xml').stat().st_mtime_ns}"


def digest(lines: Iterable[str]) -> str:
    """Sixteen hexadecimal digits that stand for these lines."""
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:16]

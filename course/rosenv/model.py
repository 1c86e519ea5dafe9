"""Which ROS 2 the course uses: the one value that travels from room to room."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

Origin = Literal["sourced", "installed", "pip"]


@dataclass(frozen=True)
class Ros:
    """A ROS 2 that nodes can be built for and run with.

    `origin` says how it was found: "sourced" in the environment, "installed" below /opt/ros, or "pip" wheels.
    `prefix` is the folder with share/ament_index in which rclpy lies, `python` the interpreter for its nodes.
    `identity` is a short hexadecimal text that changes whenever the ROS packages, their place or the Python
    change: whatever was built or cached for another identity must not be used.
    `notes` are sentences that `doctor` shows: all works, but someone should know.
    """

    origin: Origin
    distro: str
    prefix: Path
    python: Path
    identity: str
    site_packages: Path | None = None
    notes: tuple[str, ...] = ()

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
    """The folders of `prefix` that Python packages are imported from, as far as they exist."""
    return tuple(folder for pattern in _PYTHON_FOLDERS for folder in sorted(prefix.glob(pattern)))

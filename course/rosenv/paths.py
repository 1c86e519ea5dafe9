"""Which of the sourced folders belong to a ROS 2.

A learner's own install/ is a workspace on top of a sourced ROS. The course itself builds what it grades, so
the learner's old build must not replace something that is missing, or change the identity of the ROS.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

_PATH_VARIABLES = ("AMENT_PREFIX_PATH", "COLCON_PREFIX_PATH")


@dataclass(frozen=True)
class Sourced:
    """`rclpy` is the prefix that contains rclpy, `kept` are all of that ROS, `dropped` those on top of it."""

    rclpy: Path
    kept: tuple[Path, ...]
    dropped: tuple[Path, ...]


def sourced_prefixes(environ: Mapping[str, str]) -> Sourced | None:
    """The prefixes that are sourced; None if there is no rclpy among them."""
    paths = [Path(path) for path in split(environ.get("AMENT_PREFIX_PATH"))]
    base = next((index for index, path in enumerate(paths) if has_rclpy(path)), None)
    if base is None:
        return None
    workspace = paths[base].parent if _is_isolated(paths[base]) else None
    kept = tuple(path for index, path in enumerate(paths) if index >= base or path.parent == workspace)
    return Sourced(paths[base], kept, tuple(path for path in paths if path not in kept))


def has_rclpy(prefix: Path) -> bool:
    """Whether rclpy is registered in this prefix."""
    return (prefix / "share/ament_index/resource_index/packages/rclpy").exists()


def every_prefix(environ: Mapping[str, str]) -> tuple[Path, ...]:
    """All sourced folders, for `without`."""
    return tuple(Path(path) for name in _PATH_VARIABLES for path in split(environ.get(name)))


def without(paths: list[str], dropped: tuple[Path, ...]) -> list[str]:
    """`paths` without those that are in a dropped prefix, or are the workspace around it."""
    workspaces = {str(prefix.parent) for prefix in dropped if _is_isolated(prefix)}
    inside = tuple(f"{prefix}/" for prefix in dropped)
    return [path for path in paths if path not in workspaces and not f"{path}/".startswith(inside)]


def split(value: str | None) -> list[str]:
    """The entries of a path variable, without empty ones (the current folder, for some programs)."""
    return [path for path in (value or "").split(":") if path]


def _is_isolated(prefix: Path) -> bool:
    """Whether this prefix contains a single package of a colcon workspace, and others have their own."""
    marker = prefix.parent / ".colcon_install_layout"
    return marker.exists() and marker.read_text(encoding="utf-8").strip() == "isolated"

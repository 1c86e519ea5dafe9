"""Where the course keeps what it can make again: builds, the captured environment, setup files."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path


def cache_dir(environ: Mapping[str, str]) -> Path:
    """$ROS2COURSE_CACHE, else $XDG_CACHE_HOME/ros2course, else ~/.cache/ros2course; it may not exist yet."""
    if own := environ.get("ROS2COURSE_CACHE"):
        return Path(own).absolute()
    # The XDG rules say that a relative path is to be ignored.
    xdg = Path(environ.get("XDG_CACHE_HOME", ""))
    if xdg.is_absolute():
        return xdg / "ros2course"
    home = environ.get("HOME")
    return (Path(home) if home else Path.home()) / ".cache" / "ros2course"

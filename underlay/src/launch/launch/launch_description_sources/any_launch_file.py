"""Launch files of any kind: in Python, or refused in words that the real launch uses."""

from __future__ import annotations

from pathlib import Path

import yaml

from launch.invalid_launch_file_error import InvalidLaunchFileError
from launch.launch_description import LaunchDescription
from launch.launch_description_sources.python_launch_file import (
    get_launch_description_from_python_launch_file,
)

_FRONTENDS = {".xml": "XML", ".yaml": "YAML", ".yml": "YAML"}


class InvalidFrontendLaunchFileError(InvalidLaunchFileError):
    """Neither XML nor YAML, either."""


def get_launch_description_from_any_launch_file(launch_file_path: str) -> LaunchDescription:
    path = Path(launch_file_path)
    if path.suffix in _FRONTENDS:
        raise RuntimeError(
            f"launch files in {_FRONTENDS[path.suffix]} are not offered here ('{path.name}'): write it in "
            "Python, or install ROS 2 (ros-jazzy-launch-xml, ros-jazzy-launch-yaml)"
        )
    try:
        return get_launch_description_from_python_launch_file(launch_file_path)
    except Exception as error:
        raise InvalidLaunchFileError(
            path.suffix[1:], likely_errors=[error, _not_a_frontend_file(path)]
        ) from error


def _not_a_frontend_file(path: Path) -> Exception:
    """Why it is no launch file in YAML or XML either: that is what the real one tries next."""
    try:
        tree = yaml.safe_load(path.read_bytes())
    except (yaml.YAMLError, OSError, UnicodeDecodeError):
        tree = None
    if isinstance(tree, dict) and len(tree) == 1 and "launch" not in tree:
        return RuntimeError("Expected 'launch' as root tag")
    return InvalidFrontendLaunchFileError()

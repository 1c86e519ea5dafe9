"""Launch files of any kind: the file's name tells of which."""

from __future__ import annotations

from pathlib import Path

import yaml

from launch.absent import NotOfferedError
from launch.frontend.errors import InvalidFrontendLaunchFileError
from launch.invalid_launch_file_error import InvalidLaunchFileError
from launch.launch_description import LaunchDescription
from launch.launch_description_sources.python_launch_file import (
    get_launch_description_from_python_launch_file,
)


def get_launch_description_from_any_launch_file(launch_file_path: str) -> LaunchDescription:
    """Raises InvalidLaunchFileError, which tells what each way of reading the file said."""
    path = Path(launch_file_path)
    if path.suffix != ".py":
        return _from_frontend(launch_file_path)
    try:
        return get_launch_description_from_python_launch_file(launch_file_path)
    except NotOfferedError:
        raise
    except Exception as error:
        raise InvalidLaunchFileError("py", likely_errors=[error, _not_a_frontend_file(path)]) from error


def _from_frontend(launch_file_path: str) -> LaunchDescription:
    from launch.launch_description_sources.frontend_launch_file import (
        get_launch_description_from_frontend_launch_file,
    )

    return get_launch_description_from_frontend_launch_file(launch_file_path)


def _not_a_frontend_file(path: Path) -> Exception:
    """Why it is not a launch file in YAML or XML either: that is what the real one tries next."""
    try:
        tree = yaml.safe_load(path.read_bytes())
    except (yaml.YAMLError, OSError, UnicodeDecodeError):
        tree = None
    if isinstance(tree, dict) and len(tree) == 1 and "launch" not in tree:
        return RuntimeError("Expected 'launch' as root tag")
    return InvalidFrontendLaunchFileError()

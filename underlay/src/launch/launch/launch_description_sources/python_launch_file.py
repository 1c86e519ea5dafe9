"""Launch files in Python."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

from launch.launch_description import LaunchDescription


class InvalidPythonLaunchFileError(Exception):
    """The file does not do what a launch file has to do."""


def load_python_launch_file_as_module(python_launch_file_path: str) -> ModuleType:
    """Run the file. Nothing is written beside it."""
    module = ModuleType("python_launch_file")
    module.__file__ = str(python_launch_file_path)
    source = Path(python_launch_file_path).read_bytes()
    exec(compile(source, str(python_launch_file_path), "exec", dont_inherit=True), vars(module))
    return module


def get_launch_description_from_python_launch_file(python_launch_file_path: str) -> LaunchDescription:
    module = load_python_launch_file_as_module(python_launch_file_path)
    generate = getattr(module, "generate_launch_description", None)
    if generate is None:
        raise InvalidPythonLaunchFileError(
            f"launch file at '{python_launch_file_path}' does not contain the required function "
            "'generate_launch_description()'"
        )
    description = generate()
    if not isinstance(description, LaunchDescription):
        raise InvalidPythonLaunchFileError(
            f"launch file at '{python_launch_file_path}': generate_launch_description() must return a "
            f"LaunchDescription, but it returned {_told(description)}"
        )
    return description


def _told(value: object) -> str:
    return "nothing (None)" if value is None else f"{value!r} ({type(value).__name__})"

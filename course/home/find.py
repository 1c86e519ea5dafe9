"""Which course home a command is about."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from course.errors import UsageError
from course.home.model import CourseHome, is_home

VARIABLE = "ROS2COURSE_HOME"
DEFAULT_NAME = "ros2course"


def find_home(
    option: Path | None = None, environ: Mapping[str, str] | None = None, cwd: Path | None = None
) -> CourseHome:
    """--home, else ROS2COURSE_HOME, else the folder one stands in or one above it, else ~/ros2course.

    One that is named must be a course home: no other is taken in its place. Raises UsageError.
    """
    environ = os.environ if environ is None else environ
    cwd = _here() if cwd is None else cwd
    if option is not None:
        return _named(_full(option, environ, cwd), "--home")
    if environ.get(VARIABLE):
        return _named(_full(Path(environ[VARIABLE]), environ, cwd), VARIABLE)
    default = default_home(environ)
    for folder in (cwd, *cwd.parents, default):
        if is_home(folder):
            return CourseHome(folder)
    raise UsageError(f"there is no course home here, nor at {default}", "make one: ros2course init")


def default_home(environ: Mapping[str, str] | None = None) -> Path:
    """Where `init` makes a home unless told otherwise."""
    return _user_home(os.environ if environ is None else environ) / DEFAULT_NAME


def _here() -> Path:
    try:
        return Path.cwd()
    except FileNotFoundError:
        raise UsageError("the folder you stand in was deleted", "go to another one: cd") from None


def _named(path: Path, by: str) -> CourseHome:
    if is_home(path):
        return CourseHome(path)
    reason = "is not a course home" if path.exists() else "does not exist"
    raise UsageError(f"{path} (from {by}) {reason}", f"make one there: ros2course init {path}")


def _full(path: Path, environ: Mapping[str, str], cwd: Path) -> Path:
    """Absolute. A `~` reaches us from files and editors, where no shell has replaced it."""
    if path.parts[:1] == ("~",):
        path = _user_home(environ).joinpath(*path.parts[1:])
    return Path(os.path.normpath(cwd / path))


def _user_home(environ: Mapping[str, str]) -> Path:
    return Path(environ["HOME"]) if environ.get("HOME") else Path.home()

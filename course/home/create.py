"""Makes a course home. What is already there stays as it is; what is missing is added."""

from __future__ import annotations

import json
import os
import secrets
from collections.abc import Callable
from pathlib import Path

from course.content.layout import WORKSPACE
from course.errors import StorageError, UsageError
from course.home.model import MARKER, SCHEMA_VERSION, STATE, CourseHome, is_home, read_marker
from course.home.storage import inside, storing, sweep, write_new

FOLDERS = (
    f"{WORKSPACE}/src",
    "ros2_tutorials_preamble/python",
    "sas_tutorial_workspace",
    "cmake_tutorial",
)
BASHRC = """\
# bash reads this file each time you open a terminal in your course home.
# It is yours. The lessons will ask you to add lines at its end.
"""
OnNew = Callable[[Path], None]


def create_home(path: Path, *, on_new: OnNew | None = None) -> CourseHome:
    """Make `path` a course home, or complete the one that is there.

    on_new: told of each folder and file that was made, so that a second call tells of nothing.
    Raises UsageError when the path cannot be one, StorageError when it cannot be written.
    """
    home = CourseHome(Path(os.path.normpath(path.absolute())))
    _refuse(home.path)
    tell = on_new or (lambda _new: None)
    with storing(f"the course home {home.path} cannot be made"):
        for folder in ("", *FOLDERS, STATE):
            _make_folder(home.path, folder, tell)
        with home.lock():
            sweep(home.path)
            sweep(home.state)
            _make_file(home.path, ".bashrc", BASHRC, tell)
            _make_marker(home, tell)  # last: what carries it is complete
    return home


def _refuse(path: Path) -> None:
    if path.exists() and not path.is_dir():
        raise UsageError(f"{path} is a file", "give the name of a new folder: ros2course init DIR")
    _damaged(path)  # raises for a home that is too new for us
    if not (path / STATE).exists() and _is_own_home(path):
        advice = f"choose a folder inside it: ros2course init {path / 'ros2course'}"
        raise UsageError(f"{path} is your own home, which the course leaves alone", advice)


def _damaged(path: Path) -> bool:
    """Whether there is a marker that says nothing. Raises UsageError for one of a newer ros2course."""
    try:
        if is_home(path):
            read_marker(path)
    except StorageError:
        return True
    return False


def _is_own_home(path: Path) -> bool:
    return path.exists() and Path.home().exists() and path.samefile(Path.home())


def _make_folder(home: Path, name: str, tell: OnNew) -> None:
    folder = inside(home, name) if name else home
    if not folder.is_dir():
        folder.mkdir(parents=True, exist_ok=True)
        tell(folder)


def _make_file(home: Path, name: str, content: str, tell: OnNew) -> None:
    file = inside(home, name)
    if write_new(file, content.encode()):
        tell(file)


def _make_marker(home: CourseHome, tell: OnNew) -> None:
    """A damaged one is kept aside; its seed cannot be had back, so a new one is drawn."""
    if _damaged(home.path):
        (home.state / MARKER).replace(home.state / f"home.damaged-{secrets.token_hex(4)}.json")
    content = json.dumps({"schema": SCHEMA_VERSION, "seed": secrets.randbits(63)}, indent=2)
    _make_file(home.path, f"{STATE}/{MARKER}", content + "\n", tell)

"""Which course a course home belongs to, where that is not the one that comes along."""

from __future__ import annotations

from pathlib import Path

from course.errors import UsageError
from course.home.model import CourseHome
from course.home.storage import inside, storing
from course.rosenv.files import write_atomic

_FILE = "course.txt"


def remember_course(home: CourseHome, folder: Path) -> None:
    """From now on commands in this home are about the course in `folder`."""
    with storing("the course home cannot be written"):
        write_atomic(inside(home.path, f"{home.state.name}/{_FILE}"), f"{folder.absolute()}\n")


def remembered_course(home: CourseHome) -> Path | None:
    """The folder that was remembered. Raises UsageError when it is gone."""
    file = home.state / _FILE
    with storing("the course home cannot be read"):
        text = file.read_text(encoding="utf-8", errors="replace").strip() if file.is_file() else ""
    folder = Path(text) if text else None
    if folder is not None and not folder.is_dir():
        step = f"say where it is now: ros2course init {home.path} --course DIR"
        raise UsageError(f"the course of this home is gone: {folder}", step)
    return folder

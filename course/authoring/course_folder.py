"""A new course, and the folder of one that chapters are to be added to."""

from __future__ import annotations

from pathlib import Path

from course.authoring.fill import filled
from course.authoring.schemas import missing_schemas
from course.authoring.write import Made, Plan, carry_out
from course.content.layout import PARTS
from course.errors import StorageError, UsageError


def new_course(root: Path) -> Made:
    """The folders of a course without chapters. Raises UsageError when something is in `root` already."""
    if root.exists() and not root.is_dir():
        raise UsageError(f"{root} is a file", "give the name of a new folder")
    if root.is_dir() and any(_entries(root)):
        step = f"add to it: ros2course new chapter NAME --course {root}" if is_course(root) else None
        raise UsageError(f"{root} is there already, and not empty", step or "give the name of a new folder")
    words = {"title": root.name}
    new = {
        root / "README.md": filled("course/README.md", words),
        root / ".gitignore": filled("course/gitignore", words),
        root / "graders/conftest.py": filled("course/conftest.py", words),
        **missing_schemas(root),
    }
    return carry_out(Plan(new, folders=tuple(root / part for part in PARTS)), root, root.name)


def is_course(root: Path) -> bool:
    """Whether chapters may be added to it; unlike `require_course`, it need not have one."""
    return (root / "chapters").is_dir()


def require_place(root: Path) -> None:
    """Raises UsageError, with what to do, for a folder that is no course."""
    if not is_course(root):
        lack = "it has no chapters/" if root.is_dir() else "there is no such folder"
        raise UsageError(f"{root} is not a course: {lack}", f"make one: ros2course new course {root}")


def _entries(folder: Path) -> tuple[Path, ...]:
    try:
        return tuple(folder.iterdir())
    except OSError as error:
        raise StorageError(f"{folder} cannot be read: {error.strerror}", "ask its owner for access") from None

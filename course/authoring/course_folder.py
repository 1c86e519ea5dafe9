"""Makes a new course, or a new chapter in one: a lesson without exercises."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from course.authoring.write import Made, Plan, carry_out, filled, missing_schemas, schema_folder
from course.content import layout
from course.content.layout import PARTS
from course.errors import StorageError, UsageError

_SLUG = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")
_LONGEST = 40


@dataclass(frozen=True)
class NewChapter:
    """The number and name of a chapter, such as `30-power-supply`."""

    number: int
    slug: str

    @property
    def id(self) -> str:
        return f"{self.number:02d}-{self.slug}"

    @property
    def title(self) -> str:
        return titled(self.slug)


def new_course(root: Path) -> Made:
    """Make the folders of a course without chapters. Raises UsageError if `root` is not empty."""
    if root.exists() and not root.is_dir():
        raise UsageError(f"{root} is a file", "give the name of a new folder")
    if root.is_dir() and any(_entries(root)):
        step = f"add to it: ros2course new chapter NAME --course {root}" if is_course(root) else None
        raise UsageError(f"{root} already exists, and is not empty", step or "give the name of a new folder")
    words = {"title": root.name}
    new = {
        root / "README.md": filled("course/README.md", words),
        root / ".gitignore": filled("course/gitignore", words),
        root / "graders/conftest.py": filled("course/conftest.py", words),
        **missing_schemas(root),
    }
    return carry_out(Plan(new, folders=tuple(root / part for part in PARTS)), root, root.name)


def is_course(root: Path) -> bool:
    """Whether chapters can be added to it. Unlike for `require_course`, it need not have one yet."""
    return (root / "chapters").is_dir()


def require_place(root: Path) -> None:
    """Raise UsageError, with the next step, if the folder is not a course."""
    if not is_course(root):
        lack = "it has no chapters/" if root.is_dir() else "there is no such folder"
        raise UsageError(f"{root} is not a course: {lack}", f"create one: ros2course new course {root}")


def _entries(folder: Path) -> tuple[Path, ...]:
    try:
        return tuple(folder.iterdir())
    except OSError as error:
        raise StorageError(f"{folder} cannot be read: {error.strerror}", "ask its owner for access") from None


_LAST = 99


def new_chapter(root: Path, name: str) -> Made:
    """Add the chapter `30-power`, or `power` with the next number. Raises UsageError, StorageError."""
    require_place(root)
    taken = _taken(root)
    number, slug = number_and_slug(name, max(taken, default=0) + 1)
    assert number is not None
    if number in taken:
        step = f"choose a number that is free, or leave it out: {slug}"
        raise UsageError(f"there already is a chapter {number}: {taken[number]}", step)
    if number > _LAST:
        raise UsageError("there is no number after 99 for a chapter", "write a free one: 30-name")
    chapter = NewChapter(number, slug)
    return carry_out(_chapter_plan(root, chapter), root, chapter.id)


def _chapter_plan(root: Path, chapter: NewChapter) -> Plan:
    folder = root / "chapters" / chapter.id
    words = {"number": str(chapter.number), "title": chapter.title, "schema": schema_folder(root)}
    new = {
        folder / layout.LESSON: filled("chapter/lesson.yaml", words),
        folder / layout.LESSON_TEXT: filled("chapter/lesson.md", words),
        folder / layout.MISTAKES: filled("chapter/mistakes.yaml", words),
    }
    return Plan({**new, **missing_schemas(root)})


def _taken(root: Path) -> dict[int, str]:
    folders = (folder.name for folder in layout.chapter_folders(root))
    return {int(match[1]): name for name in folders if (match := layout.CHAPTER_FOLDER.fullmatch(name))}


def titled(slug: str) -> str:
    """`battery-level` as a heading: `Battery level`."""
    return slug.replace("-", " ").capitalize()


def number_and_slug(name: str, number: int | None = None) -> tuple[int | None, str]:
    """The two parts of `30-battery`; `number` if none is written. Raises UsageError for any other form."""
    match = re.fullmatch(r"(?:(\d\d)-)?(.*)", name, re.DOTALL)
    written, slug = (match[1], match[2]) if match else (None, name)
    if not _SLUG.fullmatch(slug):
        raise UsageError(
            f"`{name}` is not a name for a chapter or an exercise",
            "allowed: lowercase letters and digits joined by dashes, starting with a letter, "
            "after two digits and a dash: `30-battery`",
        )
    if len(slug) > _LONGEST:
        raise UsageError(f"`{slug}` is too long for a name", f"use at most {_LONGEST} letters")
    return (int(written) if written else number), slug

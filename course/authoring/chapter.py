"""A new chapter: a lesson that waits for its exercises."""

from __future__ import annotations

from pathlib import Path

from course.authoring.course_folder import require_place
from course.authoring.fill import filled
from course.authoring.names import ChapterName, number_and_slug
from course.authoring.schemas import missing_schemas, schema_folder
from course.authoring.write import Made, Plan, carry_out
from course.content import layout
from course.errors import UsageError

_LAST = 99


def new_chapter(root: Path, name: str) -> Made:
    """Add the chapter `30-power`, or `power` with the next number. Raises UsageError, StorageError."""
    require_place(root)
    taken = _taken(root)
    number, slug = number_and_slug(name, max(taken, default=0) + 1)
    assert number is not None
    if number in taken:
        step = f"choose a number that is free, or leave it out: {slug}"
        raise UsageError(f"there is a chapter {number} already: {taken[number]}", step)
    if number > _LAST:
        raise UsageError("there is no number after 99 for a chapter", "write a free one: 30-name")
    chapter = ChapterName(number, slug)
    return carry_out(_plan(root, chapter), root, chapter.folder)


def _plan(root: Path, chapter: ChapterName) -> Plan:
    folder = root / "chapters" / chapter.folder
    words = {"number": str(chapter.number), "title": chapter.title, "schema": schema_folder(root)}
    new = {
        folder / layout.LESSON: filled("chapter/lesson.yaml", words),
        folder / layout.LESSON_TEXT: filled("chapter/lesson.md", words),
        folder / layout.MISTAKES: filled("chapter/mistakes.yaml", words),
    }
    return Plan({**new, **missing_schemas(root)})


def _taken(root: Path) -> dict[int, str]:
    """The numbers of the chapters that are there."""
    folders = (folder.name for folder in layout.chapter_folders(root))
    return {int(match[1]): name for name in folders if (match := layout.CHAPTER_FOLDER.fullmatch(name))}

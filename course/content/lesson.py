"""Reads lesson.yaml: schema first, then what only the folder's name and the other entries can tell."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from course.content.document import Document, read_document
from course.content.explain import check
from course.content.layout import CHAPTER_FOLDER, LESSON
from course.content.question_problems import question_problems
from course.content.schema import LessonSchema
from course.errors import ContentError


@dataclass(frozen=True)
class LessonReading:
    """`data`: the file's content with defaults filled in; None when `problems` says why it is not usable."""

    data: dict[str, Any] | None
    problems: tuple[ContentError, ...]
    document: Document | None = None


def read_lesson(folder: Path) -> LessonReading:
    try:
        document = read_document(folder / LESSON)
    except ContentError as error:
        return LessonReading(None, (error,))
    data, problems = check(document, LessonSchema)
    if data is not None:
        problems = tuple(_disagreements(document, data, folder.name))
    return LessonReading(None if problems else data, problems, document)


def _disagreements(document: Document, data: dict[str, Any], folder: str) -> Iterator[ContentError]:
    match = CHAPTER_FOLDER.fullmatch(folder)
    if not match:
        what = f"the chapter's folder `{folder}` is not named like `18-publishers-and-subscribers`"
        yield document.error(what, "allowed: two digits, then small letters and digits joined by dashes")
    elif int(match[1]) != data["chapter"]:
        what = f"`chapter` is {data['chapter']}, but the folder is `{folder}`"
        yield document.error(what, f"allowed: {int(match[1])}", place=("chapter",))
    yield from _bad_ids(document, data)
    yield from question_problems(document, data)


def _bad_ids(document: Document, data: dict[str, Any]) -> Iterator[ContentError]:
    prefix = f"{data['chapter']:02d}-"
    first: dict[str, int] = {}
    for index, exercise in enumerate(data["exercises"]):
        place = ("exercises", index, "id")
        if not exercise["id"].startswith(prefix):
            what = f"`{exercise['id']}` must begin with `{prefix}`, the number of its chapter"
            yield document.error(what, f"allowed: `{prefix}` and a name", place=place)
        if exercise["id"] in first:
            what = f"`{exercise['id']}` is used twice; the first is in line {first[exercise['id']]}"
            yield document.error(what, "give each exercise an id of its own", place=place)
        first.setdefault(exercise["id"], document.line(place))

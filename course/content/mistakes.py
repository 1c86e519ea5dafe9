"""Reads what proves a grader: the chapter's mistakes.yaml, and alternatives beside its solution."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from course.content.document import Document, read_document
from course.content.entries import Alternative, Edit, Mistake
from course.content.layout import ALTERNATIVE, MISTAKES
from course.content.schema import AlternativeSchema, MistakesSchema
from course.content.schema_errors import check
from course.errors import ContentError


@dataclass(frozen=True)
class MistakesReading:
    mistakes: tuple[Mistake, ...] = ()
    problems: tuple[ContentError, ...] = ()
    document: Document | None = None


@dataclass(frozen=True)
class AlternativeReading:
    alternative: Alternative | None
    problems: tuple[ContentError, ...] = ()
    document: Document | None = None


def load_mistakes(chapter: Path) -> tuple[Mistake, ...]:
    """None when the chapter has no mistakes.yaml. Raises ContentError for the first thing that is wrong."""
    reading = read_mistakes(chapter)
    if reading.problems:
        raise reading.problems[0]
    return reading.mistakes


def load_alternatives(solution: Path) -> tuple[Alternative, ...]:
    """Raises ContentError for the first thing that is wrong."""
    readings = tuple(read_alternatives(solution))
    for reading in readings:
        if reading.problems:
            raise reading.problems[0]
    return tuple(reading.alternative for reading in readings if reading.alternative)


def read_mistakes(chapter: Path) -> MistakesReading:
    if not (chapter / MISTAKES).exists():
        return MistakesReading()
    try:
        document = read_document(chapter / MISTAKES)
    except ContentError as error:
        return MistakesReading(problems=(error,))
    data, problems = check(document, MistakesSchema)
    if data is None:
        return MistakesReading((), problems, document)
    mistakes = tuple(_mistake(item) for item in data["mistakes"])
    return MistakesReading(mistakes, tuple(_repeated(document, mistakes)), document)


def read_alternatives(solution: Path) -> Iterator[AlternativeReading]:
    """Every folder in the solution's alternatives/, by name."""
    root = solution / "alternatives"
    folders = sorted(path for path in root.iterdir() if path.is_dir()) if root.is_dir() else []
    for folder in folders:
        yield _read_alternative(folder)


def _read_alternative(folder: Path) -> AlternativeReading:
    try:
        document = read_document(folder / ALTERNATIVE)
    except ContentError as error:
        return AlternativeReading(None, (error,))
    data, problems = check(document, AlternativeSchema)
    if data is None:
        return AlternativeReading(None, problems, document)
    alternative = Alternative(
        name=folder.name,
        exercises=tuple(data["exercises"]),
        summary=data["summary"],
        deletes=tuple(data["deletes"]),
        tree=folder,
        answers=data["answers"],
    )
    return AlternativeReading(alternative, (), document)


def _mistake(data: dict[str, Any]) -> Mistake:
    return Mistake(
        id=data["id"],
        exercise=data["exercise"],
        summary=data["summary"],
        edits=tuple(_edit(item) for item in data["edits"]),
        caught_by=data["caught_by"],
        says=tuple(data["says"]),
        also_fails=tuple(data["also_fails"]),
    )


def _edit(data: dict[str, Any]) -> Edit:
    renamed = {("with_" if key == "with" else key): value for key, value in data.items()}
    return Edit(**renamed)


def _repeated(document: Document, mistakes: tuple[Mistake, ...]) -> Iterator[ContentError]:
    first: dict[str, int] = {}
    for index, mistake in enumerate(mistakes):
        place = ("mistakes", index, "id")
        if mistake.id in first:
            what = f"`{mistake.id}` is used twice; the first is in line {first[mistake.id]}"
            yield document.error(what, "give each mistake an id of its own", place=place)
        first.setdefault(mistake.id, document.line(place))

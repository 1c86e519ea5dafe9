"""Reads what graders are tested with: the chapter's mistakes.yaml, and alternatives to its solution."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import msgspec

from course.content.document import Document
from course.content.entries import Alternative, Mistake
from course.content.layout import ALTERNATIVE, MISTAKES
from course.content.schema import AlternativeSchema, MistakesSchema
from course.content.schema_errors import Reading, T, read_checked

Mistakes = tuple[Mistake, ...]


def load_mistakes(chapter: Path) -> Mistakes:
    """Empty if the chapter has no mistakes.yaml. Raises ContentError for the first thing that is wrong."""
    return _sound(read_mistakes(chapter)) or ()


def load_alternatives(solution: Path) -> tuple[Alternative, ...]:
    """Raises ContentError for the first thing that is wrong."""
    return tuple(filter(None, map(_sound, read_alternatives(solution))))


def _sound(reading: Reading[T]) -> T | None:
    if reading.problems:
        raise reading.problems[0]
    return reading.value


def read_mistakes(chapter: Path) -> Reading[Mistakes]:
    """The reading's value is None if the chapter has no mistakes.yaml."""
    if not (chapter / MISTAKES).exists():
        return Reading(None)
    return read_checked(chapter / MISTAKES, MistakesSchema, _mistakes)


def _mistakes(document: Document, found: MistakesSchema) -> Reading[Mistakes]:
    mistakes = msgspec.convert(found.mistakes, Mistakes, from_attributes=True)
    twice = document.used_twice("mistake", [mistake.id for mistake in mistakes], ("mistakes",))
    return Reading(mistakes, tuple(twice), document)


def read_alternatives(solution: Path) -> Iterator[Reading[Alternative]]:
    """Read every folder in the solution's alternatives/, sorted by name."""
    root = solution / "alternatives"
    folders = sorted(path for path in root.iterdir() if path.is_dir()) if root.is_dir() else []
    return (read_checked(folder / ALTERNATIVE, AlternativeSchema, _alternative) for folder in folders)


def _alternative(document: Document, found: AlternativeSchema) -> Reading[Alternative]:
    tree = document.file.parent
    data = {**found.model_dump(), "name": tree.name, "tree": tree}
    return Reading(msgspec.convert(data, Alternative), (), document)

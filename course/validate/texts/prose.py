"""Every text that learners read: lessons and exercises, and those that stand in lesson.yaml."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from course.content import Exercise, layout
from course.content.document import Document, Place
from course.validate.texts.subject import Subject, text_of

# `hints: |` and the like: the text begins in the next line.
_BLOCK = re.compile(r"[|>][-+\d]*\s*$")


@dataclass(frozen=True)
class Prose:
    """A Markdown text. line: of the file in which it begins. hint: its number, counted from the last (-1)."""

    file: Path
    line: int
    text: str
    exercise: str | None = None
    hint: int | None = None

    def at(self, line: int) -> int:
        """The file's line of a line of the text."""
        return self.line + line - 1


def prose(subject: Subject) -> Iterator[Prose]:
    for chapter in subject.chapters:
        for name in (layout.LESSON_TEXT, "README.md"):
            yield from _file(chapter / name)
        for index, exercise in enumerate(subject.exercises_of(chapter)):
            yield from _file(layout.exercise_text(chapter, exercise.id), exercise.id)
            document = subject.lessons[chapter].document
            if document is not None:
                yield from _in_yaml(document, exercise, index)


def _file(file: Path, exercise: str | None = None) -> Iterator[Prose]:
    text = text_of(file)
    if text is not None:
        yield Prose(file, 1, text, exercise)


def _in_yaml(document: Document, exercise: Exercise, index: int) -> Iterator[Prose]:
    """Not the choices and known wrong answers of a question: what they show may be wrong on purpose."""
    lines = (text_of(document.file) or "").splitlines()
    for place, text, hint in _texts(document.data["exercises"][index], ("exercises", index)):
        line = document.line(place)
        begins = line + 1 if len(lines) >= line and _BLOCK.search(lines[line - 1]) else line
        yield Prose(document.file, begins, text, exercise.id, hint)


def _texts(data: dict[str, Any], place: Place) -> Iterator[tuple[Place, str, int | None]]:
    hints = data.get("hints", [])
    for number, hint in enumerate(hints):
        yield (*place, "hints", number), hint, number - len(hints)
    for key in ("summary", "after"):
        if data.get(key):
            yield (*place, key), data[key], None
    for number, question in enumerate(data.get("questions", [])):
        for key in ("ask", "explain", "otherwise"):
            if question.get(key):
                yield (*place, "questions", number, key), question[key], None

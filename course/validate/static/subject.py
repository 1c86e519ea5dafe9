"""A course for the rules: each file and text is read once, and what cannot be read is left out.

`course.content.problems` reports what is left out, so no rule needs to report it again.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, TypeAlias

from course.content import Alternative, Course, Exercise, layout
from course.content.document import Place
from course.content.lesson import read_lesson
from course.content.mistakes import Mistakes, read_alternatives, read_mistakes
from course.content.schema_errors import Reading
from course.validate.static.graders import GraderModule, read_graders

_NOT_OURS = {"__pycache__", ".pytest_cache", ".ruff_cache", ".mypy_cache", ".DS_Store"}


@dataclass(frozen=True)
class Subject:
    course: Course

    @cached_property
    def chapters(self) -> tuple[Path, ...]:
        return layout.chapter_folders(self.course.root)

    @cached_property
    def exercises(self) -> Mapping[str, Exercise]:
        """All that can be read, by id."""
        return {exercise.id: exercise for exercise in self.course.readable_exercises()}

    def exercises_of(self, chapter: Path) -> tuple[Exercise, ...]:
        return tuple(one for one in self.exercises.values() if one.folder == chapter)

    def is_read(self, chapter: Path) -> bool:
        """Whether its exercises are known. If not, a finding says why, and any file may belong to them."""
        data = self.lessons[chapter].value
        return data is not None and len(data["exercises"]) == len(self.exercises_of(chapter))

    @cached_property
    def lessons(self) -> Mapping[Path, Reading[dict[str, Any]]]:
        return {chapter: read_lesson(chapter) for chapter in self.chapters}

    @cached_property
    def mistakes(self) -> Mapping[Path, Reading[Mistakes]]:
        return {chapter: read_mistakes(chapter) for chapter in self.chapters}

    @cached_property
    def alternatives(self) -> tuple[Reading[Alternative], ...]:
        folders = map(layout.solution_folder, self.chapters)
        return tuple(reading for folder in folders for reading in read_alternatives(folder))

    @cached_property
    def graders(self) -> Mapping[Path, GraderModule]:
        """Grader modules by chapter, for chapters that have one."""
        files = {chapter: layout.grader_file(chapter) for chapter in self.chapters}
        return {chapter: read_graders(file) for chapter, file in files.items() if file.is_file()}


def files_in(folder: Path) -> Iterator[Path]:
    """All files below a folder, except those that tools leave behind."""
    for path in sorted(folder.rglob("*")):
        if not path.is_dir() and not _NOT_OURS & set(path.parts) and path.suffix != ".pyc":
            yield path


def text_of(file: Path) -> str | None:
    """A file's text; None if it is not text or cannot be read."""
    try:
        return file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return None


# After `hints: |` and the like, the text begins in the next line.
_BLOCK = re.compile(r"[|>][-+\d]*\s*$")


@dataclass(frozen=True)
class Prose:
    """A Markdown text. line: where it begins in the file. hint: its number, counted from the last (-1)."""

    file: Path
    line: int
    text: str
    exercise: str | None = None
    hint: int | None = None

    def at(self, line: int) -> int:
        """The line in the file for a line of the text."""
        return self.line + line - 1


def prose(subject: Subject) -> Iterator[Prose]:
    """All texts except choices and known wrong answers, which may be wrong on purpose."""
    for chapter in subject.chapters:
        for name in (layout.LESSON_TEXT, "README.md"):
            yield from _file(chapter / name)
        for exercise in subject.exercises_of(chapter):
            yield from _file(layout.exercise_text(chapter, exercise.id), exercise.id)
        yield from _in_yaml(subject, chapter, _texts)


def choices(subject: Subject) -> Iterator[Prose]:
    """The choices and known wrong answers of questions, and why they are wrong."""
    for chapter in subject.chapters:
        yield from _in_yaml(subject, chapter, _choices)


def _file(file: Path, exercise: str | None = None) -> Iterator[Prose]:
    text = text_of(file)
    if text is not None:
        yield Prose(file, 1, text, exercise)


# Yields the texts in an exercise's data with their places, and for a hint its number.
_Texts: TypeAlias = Callable[[dict[str, Any], Place], Iterator[tuple[Place, str, Any]]]


def _in_yaml(subject: Subject, chapter: Path, texts: _Texts) -> Iterator[Prose]:
    document = subject.lessons[chapter].document
    if document is None:
        return
    lines = (text_of(document.file) or "").splitlines()
    for index, exercise in enumerate(subject.exercises_of(chapter)):
        for place, text, hint in texts(document.data["exercises"][index], ("exercises", index)):
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


def _choices(data: dict[str, Any], place: Place) -> Iterator[tuple[Place, str, None]]:
    for number, question in enumerate(data.get("questions", [])):
        for kind in ("choices", "wrong"):
            for index, choice in enumerate(question.get(kind, [])):
                for key in ("text", "why"):
                    if choice.get(key):
                        yield (*place, "questions", number, kind, index, key), choice[key], None

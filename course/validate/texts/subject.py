"""A course as the rules look at it: each of its files read once, and what cannot be read left out.

What is left out is told by `course.content.problems`, so no rule has to tell it again.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from course.content import Course, Exercise, layout
from course.content.lesson import LessonReading, read_lesson
from course.content.proofs import AlternativeReading, MistakesReading, read_alternatives, read_mistakes
from course.validate.texts.graders.reading import Graders, read_graders

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

    @cached_property
    def lessons(self) -> Mapping[Path, LessonReading]:
        return {chapter: read_lesson(chapter) for chapter in self.chapters}

    @cached_property
    def mistakes(self) -> Mapping[Path, MistakesReading]:
        return {chapter: read_mistakes(chapter) for chapter in self.chapters}

    @cached_property
    def alternatives(self) -> tuple[AlternativeReading, ...]:
        folders = map(layout.solution_folder, self.chapters)
        return tuple(reading for folder in folders for reading in read_alternatives(folder))

    @cached_property
    def graders(self) -> Mapping[Path, Graders]:
        """By chapter, of those that have a grader module."""
        files = {chapter: layout.grader_file(chapter) for chapter in self.chapters}
        return {chapter: read_graders(file) for chapter, file in files.items() if file.is_file()}


def files_in(folder: Path) -> Iterator[Path]:
    """All files below a folder, but what tools leave behind."""
    for path in sorted(folder.rglob("*")):
        if not path.is_dir() and not _NOT_OURS & set(path.parts) and path.suffix != ".pyc":
            yield path


def text_of(file: Path) -> str | None:
    """A file's text; None for one that has none, or cannot be read."""
    try:
        return file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return None

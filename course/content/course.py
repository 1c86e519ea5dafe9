"""A course folder, opened: its chapters in order, each read when it is asked for."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from itertools import takewhile
from pathlib import Path

from course.content import layout, lookup
from course.content.cache import LessonCache
from course.content.chapter import lesson_of, load_chapter, read_text
from course.content.model import Chapter, Exercise, Lesson
from course.errors import ContentError


class Course:
    """Chapters and exercises of `root`. A chapter is read once, when first needed."""

    def __init__(self, root: Path, cache: Path | None = None) -> None:
        self.root = root
        self._folders = layout.chapter_folders(root)
        self._cache = LessonCache(cache) if cache else None
        self._loaded: dict[Path, Chapter] = {}

    def chapters(self) -> tuple[Chapter, ...]:
        """All chapters. Raises ContentError when a file of the course is wrong."""
        return tuple(self._load(folder) for folder in self._folders)

    def exercises(self) -> tuple[Exercise, ...]:
        """All exercises, in the order in which they are done."""
        return tuple(exercise for chapter in self.chapters() for exercise in chapter.exercises)

    def exercise(self, wanted: str) -> Exercise:
        """The exercise of that id, or of an abbreviation that fits only one: `18-pub`, `publisher`, `18`.

        Raises UsageError with the nearest ids when there is none. Reads only the chapter that the
        number names; a bare name makes it read them all.
        """
        name = lookup.tidy(wanted)
        exercises = {exercise.id: exercise for exercise in self._numbered(lookup.chapter_number(name))}
        found = lookup.choose(name, exercises)
        if found is None:
            exercises = {exercise.id: exercise for exercise in self.readable_exercises()}
            found = lookup.choose(name, exercises)
        if found is None:
            raise lookup.unknown(name, exercises)
        return exercises[found]

    def lessons(self, exercise: Exercise) -> tuple[Lesson, ...]:
        """The lesson of its chapter, behind those of chapters right before that have no exercises."""
        own = Lesson(exercise.chapter, read_text(exercise.folder / layout.LESSON_TEXT))
        return (*self._without_exercises(self._folders.index(exercise.folder)), own)

    def last_lessons(self) -> tuple[Lesson, ...]:
        """Those of the chapters after the last exercise."""
        return self._without_exercises(len(self._folders))

    def _without_exercises(self, end: int) -> tuple[Lesson, ...]:
        """Read upwards from there, no further than to the first chapter with exercises."""
        upwards = (self._load(folder) for folder in reversed(self._folders[:end]))
        return tuple(map(lesson_of, takewhile(lambda chapter: not chapter.exercises, upwards)))[::-1]

    def readable_exercises(self) -> Iterator[Exercise]:
        """All exercises but those of broken chapters, which must not keep a learner from the others."""
        for folder in self._folders:
            with contextlib.suppress(ContentError):
                yield from self._load(folder).exercises

    def _numbered(self, number: int | None) -> Iterator[Exercise]:
        """The exercises of one chapter."""
        for folder in self._folders:
            if number is not None and folder.name.startswith(f"{number:02d}-"):
                yield from self._load(folder).exercises

    def _load(self, folder: Path) -> Chapter:
        if folder not in self._loaded:
            self._loaded[folder] = load_chapter(folder, self._cache)
        return self._loaded[folder]


def open_course(folder: Path | None = None, *, cache: Path | None = None) -> Course:
    """Open the course in `folder`, or the one that travels with this package.

    cache: a folder to remember checked lessons in; saves YAML and pydantic at the next command.
    """
    root = layout.own_root(Path(__file__).parents[1]) if folder is None else folder.absolute()
    layout.require_course(root)
    return Course(root, cache)


def problems(course: Course) -> tuple[ContentError, ...]:
    """All that is wrong with the files of a course, by file and line; empty when it is right."""
    from course.content.audit import audit  # YAML and pydantic, which no learner's command should pay for

    return audit(course.root)


def shared_files(exercise: Exercise) -> frozenset[str]:
    """Those of the exercise's files that other exercises of its course list too (a package's setup.py)."""
    course = Course(exercise.folder.parents[1])
    others = (other for other in course.readable_exercises() if other.id != exercise.id)
    return frozenset(exercise.files) & {file for other in others for file in other.files}

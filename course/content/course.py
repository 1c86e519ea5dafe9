"""An open course folder: its chapters in order, each read on demand."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterable, Iterator
from itertools import takewhile
from pathlib import Path

from course.content import layout
from course.content.chapter import Chapter, Exercise, Lesson, LessonCache, lesson_of, load_chapter
from course.errors import ContentError, UsageError
from course.spelling import close_names


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
        """The exercise with this id, or with an abbreviation that fits only one: `18-pub`, `publisher`, `18`.

        Raises UsageError with the nearest ids if there is none. Reads only the chapter that the
        number names, or all of them if that finds nothing.
        """
        name = tidy(wanted)
        exercises = {exercise.id: exercise for exercise in self._numbered(chapter_number(name))}
        found = choose(name, exercises)
        if found is None:
            exercises = {exercise.id: exercise for exercise in self.readable_exercises()}
            found = choose(name, exercises)
        if found is None:
            raise unknown(name, exercises)
        return exercises[found]

    def lessons(self, exercise: Exercise, *, whole: bool = False) -> tuple[Lesson, ...]:
        """The exercise's step of the lesson, or the whole, after any lessons without exercises before it."""
        own = lesson_of(self._load(exercise.folder), None if whole else exercise)
        return (*self._without_exercises(self._folders.index(exercise.folder)), own)

    def last_lessons(self) -> tuple[Lesson, ...]:
        """The lessons of the chapters after the last exercise."""
        return self._without_exercises(len(self._folders))

    def _without_exercises(self, end: int) -> tuple[Lesson, ...]:
        upwards = (self._load(folder) for folder in reversed(self._folders[:end]))
        return tuple(map(lesson_of, takewhile(lambda chapter: not chapter.exercises, upwards)))[::-1]

    def readable_exercises(self) -> Iterator[Exercise]:
        """All exercises except those of broken chapters, which must not keep a learner from the rest."""
        for folder in self._folders:
            with contextlib.suppress(ContentError):
                yield from self._load(folder).exercises

    def _numbered(self, number: int | None) -> Iterator[Exercise]:
        for folder in self._folders:
            if number is not None and folder.name.startswith(f"{number:02d}-"):
                yield from self._load(folder).exercises

    def _load(self, folder: Path) -> Chapter:
        if folder not in self._loaded:
            self._loaded[folder] = load_chapter(folder, self._cache)
        return self._loaded[folder]


def open_course(folder: Path | None = None, *, cache: Path | None = None) -> Course:
    """Open the course in `folder`, or the one that ships with this package.

    cache: a folder for checked lessons, so that the next command need not import YAML and pydantic.
    """
    root = layout.own_root(Path(__file__).parents[1]) if folder is None else folder.absolute()
    layout.require_course(root)
    return Course(root, cache)


def problems(course: Course) -> tuple[ContentError, ...]:
    """Everything that is wrong with a course's files, sorted by file and line; empty if nothing is."""
    from course.content.audit import audit  # imports YAML and pydantic: too slow for a learner's commands

    return audit(course.root)


def shared_files(exercise: Exercise) -> frozenset[str]:
    """The exercise's files that other exercises of the course also list, such as a package's setup.py."""
    course = Course(exercise.folder.parents[1])
    others = (other for other in course.readable_exercises() if other.id != exercise.id)
    return frozenset(exercise.files) & {file for other in others for file in other.files}


def chapter_number(wanted: str) -> int | None:
    """18 for `18-publisher`, `18-pub` and `18`; None if it does not start with a number."""
    match = re.match(r"(\d+)(-|$)", wanted)
    return int(match[1]) if match else None


def tidy(wanted: str) -> str:
    """Turn what a user typed into the form of an id."""
    return wanted.strip().lower().replace("_", "-").replace(" ", "-")


def choose(wanted: str, ids: Iterable[str]) -> str | None:
    """The id that `wanted` equals or abbreviates, or None. Raises UsageError if several fit."""
    known = tuple(ids)
    for fits in (_is_id, _is_name, _is_chapter, _begins_id, _begins_name):
        found = [candidate for candidate in known if wanted and fits(wanted, candidate)]
        if len(found) == 1:
            return found[0]
        if found:
            raise UsageError(f"`{wanted}` matches several exercises", f"say which one: {_listed(found)}")
    return None


def unknown(wanted: str, ids: Iterable[str]) -> UsageError:
    """An error that suggests the most similar ids, by the whole id or by the part after the number."""
    known = tuple(ids)
    names = {_name(candidate): candidate for candidate in known}
    alike = [*close_names(wanted, known), *(names[name] for name in close_names(_name(wanted), names))]
    guess = f"did you mean {' or '.join(list(dict.fromkeys(alike))[:3])}? " if alike else ""
    return UsageError(f"there is no exercise `{wanted}`", f"{guess}`ros2course list` shows them all")


def _listed(ids: list[str]) -> str:
    return ", ".join(ids[:6]) + (", ..." if len(ids) > 6 else "")


def _name(exercise: str) -> str:
    return re.sub(r"^\d+-", "", exercise)


def _is_id(wanted: str, candidate: str) -> bool:
    return _padded(wanted) == candidate


def _is_name(wanted: str, candidate: str) -> bool:
    return wanted == _name(candidate)


def _is_chapter(wanted: str, candidate: str) -> bool:
    return _padded(wanted) == candidate[:2]


def _begins_id(wanted: str, candidate: str) -> bool:
    return "-" in wanted and candidate.startswith(_padded(wanted))


def _begins_name(wanted: str, candidate: str) -> bool:
    return _name(candidate).startswith(wanted)


def _padded(wanted: str) -> str:
    """`2-script` becomes `02-script`."""
    return re.sub(r"^(\d)(?=-|$)", r"0\1", wanted)

"""Copies an exercise's starter files into the course home. A learner's file is never overwritten."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from course.content import Exercise, answers_file
from course.files import sweep, write_atomic
from course.home.course_home import CourseHome
from course.home.storage import copy_new, inside, storing

_NOT_STARTERS = {"__pycache__", ".pytest_cache", ".DS_Store"}


def begin(home: CourseHome, exercise: Exercise) -> tuple[Path, ...]:
    """Copy the starter files that are missing; returns those, as paths in the home.

    A killed command leaves only complete files; the next one adds the rest.
    """
    files = starter_files(exercise)
    with storing(f"the starter of {exercise.id} cannot be copied"):
        if all((home.path / file).exists() for file in files):
            return ()  # nothing to write, so a read-only home will do
        with home.lock():
            return tuple(_lay(home, exercise.starter, files))


def starter_files(exercise: Exercise) -> tuple[str, ...]:
    """The starter's files, relative to the course home."""
    found = (path for path in exercise.starter.rglob("*") if path.is_symlink() or not path.is_dir())
    relative = (path.relative_to(exercise.starter) for path in found)
    return tuple(sorted(path.as_posix() for path in relative if not _NOT_STARTERS & set(path.parts)))


def _lay(home: CourseHome, starter: Path, files: tuple[str, ...]) -> Iterator[Path]:
    targets = [(starter / file, inside(home.path, file)) for file in files]  # check all before writing any
    for source, target in targets:
        target.parent.mkdir(parents=True, exist_ok=True)
        sweep(target.parent)
        if copy_new(source, target):
            yield target


def keep_answers(home: CourseHome, exercise: str, text: str) -> None:
    """Write the exercise's answers, completely or not at all. The caller must hold the home's lock.

    Raises StorageError if they cannot be written, UsageError if a folder is a link that leads elsewhere.
    """
    name = answers_file(exercise)
    with storing(f"{name} cannot be written"):
        write_atomic(inside(home.path, name), text)

"""Tells of saves in a course home: of files that a check may look at, and of no others."""

from __future__ import annotations

import os
from collections.abc import AsyncIterator, Iterable
from fnmatch import fnmatchcase
from pathlib import Path, PurePosixPath

from watchfiles import Change, DefaultFilter, awatch

from course.content import Exercise
from course.content.layout import answers_file
from course.errors import MissingHere
from course.home import CourseHome, is_home

# Changes that follow one another sooner than this are one save, in milliseconds: an editor writes a file
# in several steps.
QUIET = 50
# While saves never stop, they are told of after this time, in milliseconds.
LONGEST = 500
# What `colcon build` makes in a workspace.
_BUILT = frozenset({"build", "install", "log"})
_LEFT_BY_TOOLS = DefaultFilter()


async def saves(home: CourseHome) -> AsyncIterator[tuple[str, ...]]:
    """What was written or removed in the home, relative to it, each time it has been quiet for a moment.

    Ends when the home is gone. Raises MissingHere when this machine cannot tell of changes.
    """

    def is_of_interest(change: Change, path: str) -> bool:
        return path == str(home.path) or not path.startswith(str(home.state))

    try:
        async for changes in awatch(
            home.path,
            watch_filter=is_of_interest,
            step=QUIET,
            debounce=LONGEST,
            ignore_permission_denied=True,
        ):
            if not is_home(home.path):
                return
            yield tuple(sorted(os.path.relpath(path, home.path) for _, path in changes))
    except OSError as error:
        if not is_home(home.path):
            return
        raise _cannot_watch(home.path, error) from error


def concerning(exercise: Exercise, files: Iterable[str]) -> tuple[str, ...]:
    """Those of the files of a course home that can change what comes out for the exercise.

    Hidden files and what `colcon build` made count only where the exercise looks at them.
    """
    patterns = (*exercise.files, *exercise.looks_at, answers_file(exercise.id))
    return tuple(file for file in files if _concerns(PurePosixPath(file), patterns))


def _concerns(file: PurePosixPath, patterns: Iterable[str]) -> bool:
    if not _LEFT_BY_TOOLS(Change.modified, str(file)):
        return False
    if any(_fits(file, PurePosixPath(pattern)) for pattern in patterns):
        return True
    is_hidden = any(part.startswith(".") for part in file.parts)
    return not is_hidden and not _BUILT.intersection(file.parts[:2])


def _fits(file: PurePosixPath, pattern: PurePosixPath) -> bool:
    """Match the pattern as a shell does: `*` does not match a hidden name."""
    if len(file.parts) != len(pattern.parts):
        return False
    return all(
        fnmatchcase(part, wanted) and part.startswith(".") == wanted.startswith(".")
        for part, wanted in zip(file.parts, pattern.parts, strict=True)
    )


def _cannot_watch(home: Path, error: OSError) -> MissingHere:
    step = "`WATCHFILES_FORCE_POLLING=1 ros2course watch` looks for changes in another way."
    return MissingHere(f"This machine cannot tell of saves in {home}: {error}.", step)

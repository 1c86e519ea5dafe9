"""Reports saves in a course home, but only of files that a check may look at."""

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

# Changes within this time, in milliseconds, count as one save, because an editor writes a file in several
# steps.
QUIET = 50
# If saves never stop, they are reported after this time, in milliseconds.
LONGEST = 500
# What `colcon build` makes in a workspace.
_BUILT = frozenset({"build", "install", "log"})
_LEFT_BY_TOOLS = DefaultFilter()


async def saves(home: CourseHome) -> AsyncIterator[tuple[str, ...]]:
    """The files that were written or removed, relative to the home, after each moment without changes.

    Ends when the home is gone. Raises MissingHere if this machine cannot report changes.
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
    """Those of a course home's files that can change the exercise's result.

    Hidden files and those that `colcon build` made count only if the exercise looks at them.
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
    """Matches the pattern as a shell does: `*` does not match a hidden name."""
    if len(file.parts) != len(pattern.parts):
        return False
    return all(
        fnmatchcase(part, wanted) and part.startswith(".") == wanted.startswith(".")
        for part, wanted in zip(file.parts, pattern.parts, strict=True)
    )


def _cannot_watch(home: Path, error: OSError) -> MissingHere:
    step = "`WATCHFILES_FORCE_POLLING=1 ros2course watch` looks for changes in a different way."
    return MissingHere(f"This machine cannot report saves in {home}: {error}.", step)

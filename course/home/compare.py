"""The learner's files beside the reference solution's."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from course.content import Exercise
from course.errors import ContentError
from course.home.model import CourseHome
from course.home.storage import storing

LARGEST = 1_000_000  # bytes; what is larger is no source file, and would be compared for minutes


class FileDiff(NamedTuple):
    """`diff`: unified, from the learner's file to the reference; empty when they are the same."""

    file: str
    diff: str


def solution_diff(home: CourseHome, exercise: Exercise) -> list[FileDiff]:
    """One entry for each of `exercise.files`, in their order. A missing file counts as an empty one."""
    return [FileDiff(file, _diff(file, home.path, exercise)) for file in exercise.files]


def _diff(file: str, home: Path, exercise: Exercise) -> str:
    from difflib import unified_diff  # only this command needs it

    reference = exercise.solution / file
    if not reference.is_file():
        raise ContentError(f"`{file}` is not in the reference solution", file=reference)
    with storing(f"{file} cannot be read"):
        yours = home / file
        if yours.is_file() and yours.stat().st_size > LARGEST:
            return f"Your {file} is too large to be compared.\n"
        before = _lines(yours) if yours.is_file() else []
    name = f"your {file}" if yours.is_file() else "(you have no such file)"
    return "".join(unified_diff(before, _lines(reference), name, f"reference {file}"))


def _lines(file: Path) -> list[str]:
    """Each with its line end; one that lacks it is marked as `diff` does."""
    *lines, last = file.read_bytes().decode(errors="replace").split("\n")
    return [f"{line}\n" for line in lines] + ([f"{last}\n\\ No newline at end of file\n"] if last else [])

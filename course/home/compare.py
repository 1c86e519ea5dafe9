"""Compares the learner's files with those of the reference solution."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple

from course.content import Exercise
from course.content.layout import ADDED_TO, with_addition
from course.errors import ContentError
from course.home.course_home import CourseHome
from course.home.storage import storing

LARGEST = 1_000_000  # bytes; a larger file is not source code, and comparing it would take minutes


class FileDiff(NamedTuple):
    """`diff`: unified, from the learner's file to the reference; empty when they are the same."""

    file: str
    diff: str


def solution_diff(
    home: CourseHome, exercise: Exercise, made: Mapping[str, str] = MappingProxyType({})
) -> list[FileDiff]:
    """One entry for each of `exercise.files`, in their order. A missing file counts as an empty one.

    made: texts of reference files that are generated instead of stored, by their path in the home.
    """
    return [FileDiff(file, _diff(file, home.path, exercise, made.get(file))) for file in exercise.files]


def _diff(file: str, home: Path, exercise: Exercise, made: str | None) -> str:
    from difflib import unified_diff  # only this command needs it

    reference = exercise.solution / file
    if made is None and not reference.is_file():
        raise ContentError(f"`{file}` is not in the reference solution", file=reference)
    with storing(f"{file} cannot be read"):
        yours = home / file
        if yours.is_file() and yours.stat().st_size > LARGEST:
            return f"Your {file} is too large to be compared.\n"
        before = _lines(yours) if yours.is_file() else []
        after = _reference(file, before, reference) if made is None else made.splitlines(keepends=True)
    name = f"your {file}" if yours.is_file() else "(you have no such file)"
    return "".join(unified_diff(before, after, name, f"reference {file}"))


def _reference(file: str, before: list[str], reference: Path) -> list[str]:
    return _lines(reference) if file not in ADDED_TO else _added(before, reference)


def _added(before: list[str], addition: Path) -> list[str]:
    from course.rosenv import on_this_machine  # only for the shell's files

    added = on_this_machine(addition.read_text(encoding="utf-8"))
    return with_addition("".join(before), added).splitlines(keepends=True)


def _lines(file: Path) -> list[str]:
    """The lines with their line ends. If the last one has no line end, this is marked, as in `diff`."""
    *lines, last = file.read_bytes().decode(errors="replace").split("\n")
    return [f"{line}\n" for line in lines] + ([f"{last}\n\\ No newline at end of file\n"] if last else [])

"""Which exercises of which submissions are to be graded."""

from __future__ import annotations

import contextlib
import hashlib
import os
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from course.batch.intake import Found, Kind, find_sources, look, one_source
from course.batch.intake.plan import made_of
from course.batch.intake.tree import read_tree
from course.batch.model import Unit
from course.batch.results import Submission
from course.content import Course, Exercise
from course.errors import UsageError
from course.home.opening import Finding

_STEP = 1024 * 1024


@dataclass(frozen=True)
class Planned:
    """A class as it was found. findings: about what is nobody's. chosen: whether exercises were asked for."""

    found: tuple[Found, ...]
    exercises: tuple[Exercise, ...]
    findings: tuple[Finding, ...]
    chosen: bool

    def units(self) -> Iterator[Unit]:
        for found in self.found:
            for exercise in self.exercises:
                if self.grades(found, exercise):
                    yield Unit(found.person.id, exercise.id)

    def grades(self, found: Found, exercise: Exercise) -> bool:
        """An exercise that was asked for is graded wherever there is anything: its feedback tells what

        is missing. Else those are whose files are there.
        """
        if found.kind is Kind.NOTHING:
            return False
        return self.chosen or exercise.id in found.exercises


def plan(submissions: Path, opened: Path, course: Course, wanted: Sequence[str], *, single: bool) -> Planned:
    """What is found in `submissions`. opened: a folder for archives. wanted: exercises, all if none.

    single: the folder is one submission, not a class. Raises UsageError and StorageError.
    """
    exercises = _exercises(course, wanted)
    sources = one_source(submissions) if single else find_sources(submissions, opened / "class")
    # All of them, so that a file is not taken for the only one that happens to be asked for.
    known = course.exercises()
    found = tuple(look(source, opened / source.person.id, known) for source in sources.each)
    return Planned(found, exercises, sources.findings, bool(wanted))


def exercises_named(course: Course, wanted: Iterable[str]) -> tuple[Exercise, ...]:
    """A chapter's number means all exercises of it. Raises UsageError for what does not exist."""
    chosen = [exercise for name in wanted for exercise in _named(course, name)]
    return tuple({exercise.id: exercise for exercise in chosen}.values())


def _named(course: Course, name: str) -> list[Exercise]:
    if name.isdecimal():
        found = [exercise for exercise in course.exercises() if exercise.chapter.number == int(name)]
        if found:
            return found
    return [course.exercise(name)]


def _exercises(course: Course, wanted: Iterable[str]) -> tuple[Exercise, ...]:
    chosen = exercises_named(course, wanted)
    found = chosen or tuple(exercise for exercise in course.exercises() if not exercise.local_only)
    if not found:
        raise UsageError("The course has no exercise that can be graded in a class.")
    return found


def submission_of(found: Found) -> Submission:
    """Reads all its files."""
    return Submission(found.person.id, found.person.name, found.source, digest(found), remarks_on(found))


def remarks_on(found: Found) -> tuple[str, ...]:
    return tuple(_sentence(finding) for finding in found.findings)


def _sentence(finding: Finding) -> str:
    where = f" ({finding.where})" if finding.where else ""
    return f"{finding.what}{where}"


def digest(found: Found) -> str:
    """The same for the same files in the same places."""
    hashed = hashlib.blake2b(digest_size=16)
    for name, entry in sorted(made_of(read_tree(found.parts), found.places)):
        hashed.update(os.fsencode(f"{name}\0{entry.folder}\0{entry.size}\0{entry.executable}\0"))
        if not entry.folder:
            hashed.update(_digest_of_file(entry.path))
    return hashed.hexdigest()


def _digest_of_file(file: Path) -> bytes:
    hashed = hashlib.blake2b(digest_size=16)
    with contextlib.suppress(OSError), file.open("rb") as content:  # what cannot be read is left out later
        while data := content.read(_STEP):
            hashed.update(data)
    return hashed.digest()

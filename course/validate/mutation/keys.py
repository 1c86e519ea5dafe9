"""What a recording depends on, as a digest: a kept one is used only as long as all of it is the same.

That is what the trial home is made of (the solutions of all that the exercise stands on, the right answers, a
mistake's edits or an alternative's files), the scenario, the ROS, and what in the engine records.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

import course as package
from course.content import Course, Exercise
from course.grading.scenario_digest import scenario_digest
from course.grading.trial_answers import SEED
from course.validate.plan import Kind, Proof

# What records, besides the scenario and the modules of `course.grading` that it uses.
_ENGINE = ("arena", "evidence", "build", "rosenv")
_LEFT_OUT = frozenset({"__pycache__"})


class Keys:
    """Of the recordings of one exercise. ros: the identity of the ROS that they are made with."""

    def __init__(self, course: Course, exercise: Exercise, ros: str) -> None:
        self._mistakes = {mistake.id: mistake for mistake in exercise.mistakes()}
        self._alternatives = {other.name: other for other in exercise.alternatives()}
        self._common = _digest([ros, _engine(), *_of_exercise(exercise), *_homes(course, exercise)])

    def key(self, proof: Proof) -> str:
        return _digest([self._common, str(proof), *self._own(proof)])

    def _own(self, proof: Proof) -> Iterator[str]:
        if proof.kind is Kind.MISTAKE:
            yield repr(self._mistakes[proof.name].edits)
        elif proof.kind is Kind.ALTERNATIVE:
            other = self._alternatives[proof.name]
            yield f"{other.deletes} {other.answers}"
            yield _tree(other.tree)


def _of_exercise(exercise: Exercise) -> Iterator[str]:
    yield scenario_digest(exercise.grader, exercise.id, (*exercise.files, *exercise.looks_at))
    yield f"{exercise.id} {SEED} {exercise.time_limit} {exercise.packages} {exercise.grader_packages}"
    for name in exercise.grader_packages:
        for manifest in sorted(exercise.solution.parent.glob(f"*/*workspace/src/{name}/package.xml")):
            yield _tree(manifest.parent)
    if exercise.play is not None:  # its module says also what a learner did who did everything right
        yield _tree(exercise.play)
        yield _tree(exercise.grader)


def _homes(course: Course, exercise: Exercise) -> Iterator[str]:
    """What trial homes are made of, but for alternatives and mistakes."""
    for name in exercise.requires:
        yield from _homes(course, course.exercise(name))
    yield _tree(exercise.solution, without="alternatives")
    yield repr(exercise.questions)


@cache
def _engine() -> str:
    root = Path(package.__file__).parent
    return _digest(_tree(root / room) for room in _ENGINE)


def _tree(root: Path, without: str = "") -> str:
    """Digest of a file, or of all files below a folder with their names and modes."""
    return _digest(_files(root, {*_LEFT_OUT, without}))


def _files(root: Path, without: set[str]) -> Iterator[str]:
    if root.is_file():
        yield _file(root)
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(name for name in folders if name not in without)
        for name in sorted(names):
            file = Path(folder) / name
            yield f"{file.relative_to(root)} {_file(file)}"


def _file(file: Path) -> str:
    if file.is_symlink():
        return f"-> {file.readlink()}"
    return f"{file.stat().st_mode:o} {hashlib.sha256(file.read_bytes()).hexdigest()}"


def _digest(parts: Iterable[str]) -> str:
    return hashlib.sha256("\n\0".join(parts).encode()).hexdigest()[:32]

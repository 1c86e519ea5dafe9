"""What is to be proven of a course: each proof is one grading of what the course itself supplies."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import Enum

from course.content import Exercise
from course.validate.texts.graders.reading import read_graders


class Kind(str, Enum):
    """What is graded. The first two must earn all points, the third must not pass, the fourth be caught."""

    SOLUTION = "solution"
    ALTERNATIVE = "alternative"
    STARTER = "starter"
    MISTAKE = "mistake"


@dataclass(frozen=True)
class Proof:
    """name: the alternative's or the mistake's, empty for the others."""

    exercise: str
    kind: Kind
    name: str = ""

    def __str__(self) -> str:
        return f"{self.exercise} {self.kind.value}" + (f" {self.name}" if self.name else "")


def proofs(exercises: Iterable[Exercise]) -> tuple[Proof, ...]:
    """All proofs, in the order in which they are best run: what takes long first.

    Solutions come before all: they build what the others use, too, and are watched to their end.
    Raises ContentError when mistakes or alternatives cannot be read.
    """
    weights = {exercise.id: _weight(exercise) for exercise in exercises}
    every = [proof for exercise in exercises for proof in _of(exercise)]
    return tuple(sorted(every, key=lambda proof: (_ORDER[proof.kind], -weights[proof.exercise])))


_ORDER = {Kind.SOLUTION: 0, Kind.ALTERNATIVE: 1, Kind.MISTAKE: 2, Kind.STARTER: 2}


def _of(exercise: Exercise) -> Iterator[Proof]:
    # No tree of files solves what is about the learner's own machine.
    if not exercise.local_only:
        yield Proof(exercise.id, Kind.SOLUTION)
    for other in exercise.alternatives():
        yield Proof(exercise.id, Kind.ALTERNATIVE, other.name)
    yield Proof(exercise.id, Kind.STARTER)
    for mistake in exercise.mistakes():
        yield Proof(exercise.id, Kind.MISTAKE, mistake.id)


def _weight(exercise: Exercise) -> int:
    """Roughly how long a grading takes: questions alone take no time, packages must be built."""
    if exercise.questions and not exercise.packages:
        return 0
    return 1 + len(exercise.packages)


def gradable(exercises: Iterable[Exercise]) -> tuple[Exercise, ...]:
    """Those whose grader can be loaded. The others are told of by `texts`: nothing of them can be proven."""
    graders = {exercise.grader for exercise in exercises if exercise.grader.is_file()}
    broken = {grader for grader in graders if read_graders(grader).fault}
    return tuple(exercise for exercise in exercises if exercise.grader not in broken)


def starter_builds(exercise: Exercise) -> bool:
    """Whether a learner begins with packages; else with an empty workspace."""
    return exercise.starter.is_dir() and bool(exercise.packages)

"""What must be proven about a course: each proof is one grading of something that the course itself supplies.

A proof goes to a worker, and its result comes back, as plain data: one line of JSON each.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from enum import Enum

from msgspec import Struct

from course.batch.pool import Work
from course.content import Exercise
from course.model.feedback import Feedback
from course.model.result import Result, Verdict
from course.validate.static.graders import read_graders


class ProofKind(str, Enum):
    """What is graded, in the order of `ProofRow`.

    The first two must earn all points, the third must not pass, and the fourth must be caught.
    """

    SOLUTION = "solution"
    ALTERNATIVE = "alternative"
    STARTER = "starter"
    MISTAKE = "mistake"


@dataclass(frozen=True)
class Proof:
    """name: the alternative's or the mistake's, empty for the others."""

    exercise: str
    kind: ProofKind
    name: str = ""

    def __str__(self) -> str:
        return f"{self.exercise} {self.kind.value}" + (f" {self.name}" if self.name else "")


def proofs(exercises: Iterable[Exercise]) -> tuple[Proof, ...]:
    """All proofs, in the best order to run them: long ones first.

    Solutions come before everything else, because the others use their builds, too.
    Raises ContentError if mistakes or alternatives cannot be read.
    """
    weights = {exercise.id: _weight(exercise) for exercise in exercises}
    every = [proof for exercise in exercises for proof in _proofs_of(exercise)]
    return tuple(sorted(every, key=lambda proof: (_ORDER[proof.kind], -weights[proof.exercise])))


_ORDER = {ProofKind.SOLUTION: 0, ProofKind.ALTERNATIVE: 1, ProofKind.MISTAKE: 2, ProofKind.STARTER: 2}


def _proofs_of(exercise: Exercise) -> Iterator[Proof]:
    # An exercise about the learner's own machine has no solution in files.
    if not exercise.local_only:
        yield Proof(exercise.id, ProofKind.SOLUTION)
    for other in exercise.alternatives():
        yield Proof(exercise.id, ProofKind.ALTERNATIVE, other.name)
    yield Proof(exercise.id, ProofKind.STARTER)
    for mistake in exercise.mistakes():
        yield Proof(exercise.id, ProofKind.MISTAKE, mistake.id)


def _weight(exercise: Exercise) -> int:
    """The approximate cost of a grading: questions cost nothing, builds cost most."""
    if exercise.questions and not exercise.packages:
        return 0
    return 1 + len(exercise.packages)


def gradable(exercises: Iterable[Exercise]) -> tuple[Exercise, ...]:
    """Those whose grader can be loaded. Nothing can be proven about the others; static rules report them."""
    graders = {exercise.grader for exercise in exercises if exercise.grader.is_file()}
    broken = {grader for grader in graders if read_graders(grader).fault}
    return tuple(exercise for exercise in exercises if exercise.grader not in broken)


def starter_builds(exercise: Exercise) -> bool:
    """Whether a learner begins with packages, instead of an empty workspace."""
    return exercise.starter.is_dir() and bool(exercise.packages)


class ProofTask(Struct, frozen=True):
    """turn: from 1, up to the number of times that each proof is run. attempt: in this turn, from 1.

    course: its root. folder: for temporary files. evidence: a file in which to keep the recording.
    """

    proof: Proof
    turn: int
    course: str
    folder: str
    attempt: int = 1
    evidence: str | None = None


class ProofResult(Struct, frozen=True):
    """The result of a task. laid: False if the files to grade could not be put together.

    seconds: from the beginning to the end of the task. misled: where the feedback points, if that is wrong.
    """

    proof: Proof
    turn: int
    attempt: int
    result: Result
    seconds: float
    laid: bool = True
    misled: str | None = None


def _fits(task: ProofTask, proven: ProofResult) -> bool:
    return (proven.proof, proven.turn, proven.attempt) == (task.proof, task.turn, task.attempt)


def _failed(task: ProofTask, how: str) -> ProofResult:
    fault = Feedback(summary=f"The worker that graded it {how}.")
    result = Result(task.proof.exercise, Verdict.OUR_ERROR, fault=fault)
    return ProofResult(task.proof, task.turn, task.attempt, result, 0.0)


PROOFS = Work("course.validate.prover", ProofResult, _fits, _failed)

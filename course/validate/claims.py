"""What a course claims of each proof, and whether its result bears that out."""

from __future__ import annotations

from collections.abc import Iterable

from course.content import Exercise
from course.grading.disturbed import was_disturbed
from course.grading.result import Verdict
from course.validate.judge import does_not_pass, earns_all, is_caught
from course.validate.plan import Kind, starter_builds
from course.validate.tasks import Proven


class Claims:
    """Of these exercises. Raises ContentError when their mistakes cannot be read."""

    def __init__(self, exercises: Iterable[Exercise]) -> None:
        self._exercises = {exercise.id: exercise for exercise in exercises}
        every = (mistake for exercise in self._exercises.values() for mistake in exercise.mistakes())
        self._mistakes = {(mistake.exercise, mistake.id): mistake for mistake in every}

    def faults(self, proven: Proven) -> list[str]:
        """What is otherwise than claimed, in words; see `judge`. Nothing where this machine cannot tell."""
        proof, result = proven.proof, proven.result
        if is_missing(proven):
            return []
        if proof.kind is Kind.STARTER:
            return does_not_pass(result, builds=starter_builds(self._exercises[proof.exercise]))
        if proof.kind is Kind.MISTAKE:
            return is_caught(result, self._mistakes[proof.exercise, proof.name])
        return earns_all(result)

    def is_doubtful(self, proven: Proven) -> bool:
        """Whether something is wrong that the machine, or a fault of the engine, may be to blame for."""
        ours = proven.result.verdict is Verdict.OUR_ERROR
        may_be = proven.laid and (ours or was_disturbed(proven.result.timing))
        return may_be and bool(self.faults(proven))


def is_missing(proven: Proven) -> bool:
    """Whether this machine lacks what the proof needs."""
    return proven.result.verdict is Verdict.NOT_AVAILABLE

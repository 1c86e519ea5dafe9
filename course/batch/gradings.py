"""Gradings of a class: what travels to the processes that do them, and back."""

from __future__ import annotations

from collections.abc import Callable

from msgspec import Struct

from course.batch.pool import Work
from course.model.feedback import Feedback
from course.model.result import Result, Verdict


class Unit(Struct, frozen=True):
    """One exercise of one submission. attempt: counted from 1."""

    person: str
    exercise: str
    attempt: int = 1

    def again(self) -> Unit:
        return Unit(self.person, self.exercise, self.attempt + 1)


class GradingTask(Struct, frozen=True):
    """A unit, ready to be graded. home: the laid-out course home. evidence: where to keep the recording.

    course: root of the course; None for our own. contained: refuse to run it uncontained.
    """

    unit: Unit
    home: str
    evidence: str
    course: str | None = None
    contained: bool = True


class Graded(Struct, frozen=True):
    """How a unit was graded. seconds: from its start to its end."""

    unit: Unit
    result: Result
    seconds: float


NextTask = Callable[[], GradingTask | None]


def _answers(task: GradingTask, graded: Graded) -> bool:
    return graded.unit == task.unit


def _failed(task: GradingTask, how: str) -> Graded:
    fault = Feedback(summary=f"The worker that graded it {how}.")
    return Graded(task.unit, Result(task.unit.exercise, Verdict.OUR_ERROR, fault=fault), 0.0)


GRADINGS = Work("course.batch.worker", Graded, _answers, _failed)

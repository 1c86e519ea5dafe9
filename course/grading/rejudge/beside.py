"""Recordings judged as they are made, by a process that has loaded what it needs.

Whoever grades many submissions saves what a process of its own would load for each of them.
"""

from __future__ import annotations

from pathlib import Path

from course.content import Exercise
from course.feedback import Feedback
from course.grading.channel import Judgement
from course.grading.rejudge.model import Problem, Stored, Trouble, answer_from_line
from course.grading.rejudge.process import Judges


class Beside:
    """Judges one recording at a time. Close it; it ends with its owner in any case."""

    def __init__(self) -> None:
        self._judges: Judges[None] | None = None
        self._known: dict[str, Exercise] = {}

    def judge(self, exercise: Exercise, file: Path) -> Judgement:
        """What the checks say of the recording; with a fault where it could not be judged.

        Raises OurFault when no process can be started.
        """
        self._known[exercise.id] = exercise
        self._judges = self._judges or Judges()
        self._judges.take([Stored(None, exercise, file)], self._known.values())
        while (lines := self._judges.read()) == []:
            pass
        if lines is None:
            return _fault(self._lost())
        answer = answer_from_line(lines[0])
        return _fault(answer) if isinstance(answer, Problem) else answer.judgement

    def _lost(self) -> Problem:
        """The process ended over this recording; the next one gets another."""
        assert self._judges is not None
        try:
            return Problem(Trouble.FATAL, self._judges.how_it_ended())
        finally:
            self.close()

    def close(self) -> None:
        """End the process; more than once does no harm."""
        judges, self._judges = self._judges, None
        if judges is not None:
            judges.close()


def _fault(problem: Problem) -> Judgement:
    return Judgement((), 0.0, Feedback(summary=problem.what))

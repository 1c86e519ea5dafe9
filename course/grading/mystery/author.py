"""What a grader module says of a mystery: what is right, and how its questions are worded.

    mystery = Mystery("19-inspect-topics", __file__)

    @mystery.answers
    def answers(plan): return {"rate": Number(plan.rate, "10%")}

    @mystery.words
    def words(plan): return {"topic": plan.topic}

The plan comes from `draw(seed)` in the chapter's `play/19-inspect-topics.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol

from course.arena.play_module import load_play
from course.content.layout import play_file
from course.errors import OurFault
from course.evidence.acts import Act
from course.grading.mystery.answers import Answer

Answers = Callable[[Any], Mapping[str, Answer]]
Words = Callable[[Any], Mapping[str, object]]
ActsOf = Callable[[Any], Sequence[Act]]


class Seeded(Protocol):
    """A recording or an arena."""

    @property
    def seed(self) -> int | None: ...


class Mystery:
    """The mystery of one exercise, as its grader module declares it."""

    def __init__(self, exercise: str, grader: str) -> None:
        """grader: the module's own `__file__`; the mystery's module is found from there."""
        self.exercise = exercise
        self._root = Path(grader).resolve().parents[1]
        self.answers_function: Answers | None = None
        self.words_function: Words = _no_words
        self.acts_function: ActsOf = _no_acts

    def answers(self, function: Answers) -> Answers:
        """Decorator: from a plan to the right answer of each question that is `computed`."""
        self.answers_function = function
        return function

    def words(self, function: Words) -> Words:
        """Decorator: from a plan to what stands for each `{name}` in the questions' texts."""
        self.words_function = function
        return function

    def acts(self, function: ActsOf) -> ActsOf:
        """Decorator: from a plan to the acts of a learner who did everything right; for the tests."""
        self.acts_function = function
        return function

    @property
    def file(self) -> Path:
        """The mystery's module, for `arena.play(mystery.file)`. Raises OurFault when there is none."""
        chapters = sorted(self._root.glob(f"chapters/{self.exercise[:3]}*"))
        found = (play_file(chapter, self.exercise) for chapter in chapters)
        file = next((file for file in found if file is not None), None)
        if file is None:
            raise OurFault(f"there is no play/{self.exercise}.py in the chapter", "Correct the id.")
        return file

    def plan(self, seeded: Seeded) -> Any:
        """The plan that belongs to a recording, or to the arena that it is made in."""
        if seeded.seed is None:
            raise OurFault(f"no seed was given for {self.exercise}")
        return self.draw(seeded.seed)

    def draw(self, seed: int) -> Any:
        """The plan of a seed of this exercise (see `play_module.seed_for`)."""
        return load_play(self.file).draw(seed)


def _no_words(_plan: Any) -> Mapping[str, object]:
    return {}


def _no_acts(_plan: Any) -> Sequence[Act]:
    return ()

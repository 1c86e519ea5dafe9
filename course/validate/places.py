"""Where in its files the course claims something: the lines that findings point at."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from course.content import Exercise
from course.content.layout import ALTERNATIVE, LESSON, MISTAKES
from course.content.lesson import read_lesson
from course.content.proofs import read_alternatives, read_mistakes
from course.validate.plan import Kind, Proof

Place = tuple[Path, int | None]


class Places:
    """Reads each file once."""

    def __init__(self) -> None:
        self._lessons = cache(read_lesson)
        self._mistakes = cache(read_mistakes)
        self._alternatives = cache(lambda solution: tuple(read_alternatives(solution)))

    def of(self, exercise: Exercise, proof: Proof) -> Place:
        """The mistake, the alternative, or for the solution and the starter the exercise itself."""
        if proof.kind is Kind.MISTAKE:
            return self._of_mistake(exercise, proof.name)
        if proof.kind is Kind.ALTERNATIVE:
            return self._of_alternative(exercise, proof.name)
        return self._of_exercise(exercise)

    def _of_exercise(self, exercise: Exercise) -> Place:
        reading = self._lessons(exercise.folder)
        ids = [one["id"] for one in reading.data["exercises"]] if reading.data else []
        found = exercise.id in ids and reading.document is not None
        place = ("exercises", ids.index(exercise.id), "id") if found else ()
        return exercise.folder / LESSON, reading.document.line(place) if reading.document else None

    def _of_mistake(self, exercise: Exercise, name: str) -> Place:
        reading = self._mistakes(exercise.folder)
        ids = [mistake.id for mistake in reading.mistakes]
        line = reading.document.line(("mistakes", ids.index(name), "id")) if reading.document else None
        return exercise.folder / MISTAKES, line

    def _of_alternative(self, exercise: Exercise, name: str) -> Place:
        for reading in self._alternatives(exercise.solution):
            if reading.alternative and reading.document and reading.alternative.name == name:
                place = ("exercises", reading.alternative.exercises.index(exercise.id))
                return reading.document.file, reading.document.line(place)
        return exercise.solution / "alternatives" / name / ALTERNATIVE, None

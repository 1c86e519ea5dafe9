"""A class for benchmarks, of right solutions and known mistakes."""

from __future__ import annotations

import shutil
from pathlib import Path

from course.content import Course, open_course
from course.grading import trial
from course.validate.proofs import Proof, ProofKind
from course.validate.prover import lay


def lay_mixed(folder: Path, people: int, exercise_id: str) -> list[Path]:
    """Lay out right submissions and the exercise's mistakes alternately; return their folders."""
    course = open_course()
    exercise = course.exercise(exercise_id)
    mistakes = exercise.mistakes()
    for number in range(people):
        home = folder / f"p{number:03}"
        home.mkdir(parents=True)
        if number % 2 and mistakes:
            trial.lay_mistake(course, exercise, mistakes[number // 2 % len(mistakes)], home)
        else:
            trial.lay_solution(course, exercise, home)
    return sorted(folder.iterdir())


def variants(exercise_id: str, course: Course | None = None, *, right: bool = False) -> list[tuple[str, str]]:
    """Kind and name of the solution, the alternatives, and, unless `right`, the known mistakes."""
    exercise = (course or open_course()).exercise(exercise_id)
    found = [("solution", ""), *(("alternative", other.name) for other in exercise.alternatives())]
    return found + [("mistake", mistake.id) for mistake in exercise.mistakes() if not right]


def lay_variants(
    folder: Path, people: int, exercise_id: str, course: Course | None = None, *, right: bool = False
) -> None:
    """Person n has the n-th variant, in turn. Homes that already exist stay as they are."""
    course = course or open_course()
    exercise, kinds = course.exercise(exercise_id), variants(exercise_id, course, right=right)
    for number in range(people):
        home = folder / f"p{number:05}"
        if not home.exists():
            kind, name = kinds[number % len(kinds)]
            beside = folder / f".p{number:05}"
            shutil.rmtree(beside, ignore_errors=True)
            beside.mkdir(parents=True)
            lay(course, exercise, Proof(exercise_id, ProofKind(kind), name), beside)
            beside.rename(home)  # complete or not at all

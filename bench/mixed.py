"""A class for benchmarks, of right solutions and known mistakes."""

from __future__ import annotations

from pathlib import Path

from course.content import open_course
from course.grading import trial


def lay_mixed(folder: Path, people: int, exercise_id: str) -> list[Path]:
    """Every other submission is right, the others are the exercise's mistakes in turn; their folders."""
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

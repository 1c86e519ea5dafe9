"""A course home with the reference solution of an exercise in it, for benchmarks."""

from __future__ import annotations

import contextlib
import tempfile
from collections.abc import Iterator
from pathlib import Path

from course.content import Exercise, open_course
from course.grading import trial


@contextlib.contextmanager
def solved(exercise_id: str) -> Iterator[tuple[Exercise, Path]]:
    """The exercise, and a temporary home in which it is solved."""
    course = open_course()
    exercise = course.exercise(exercise_id)
    with tempfile.TemporaryDirectory(prefix="ros2course-bench-") as folder:
        trial.lay_solution(course, exercise, Path(folder))
        yield exercise, Path(folder)

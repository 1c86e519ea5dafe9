"""Keeps what a learner answered in a terminal, in the file that `check` judges."""

from __future__ import annotations

from course.content import answers_file
from course.home.model import CourseHome
from course.home.storage import inside, storing
from course.rosenv.files import write_atomic


def keep_answers(home: CourseHome, exercise: str, text: str) -> None:
    """Write the exercise's answers, whole or not at all. For whoever holds the home's lock.

    Raises StorageError when the disk does not take it, UsageError for a folder that leads elsewhere.
    """
    name = answers_file(exercise)
    with storing(f"{name} cannot be written"):
        write_atomic(inside(home.path, name), text)

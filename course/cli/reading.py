"""Which exercise comes next, and the chapter's text that goes with it."""

from __future__ import annotations

from course.cli.desk import Desk
from course.content import Exercise
from course.content.chapter import read_text
from course.content.layout import LESSON_TEXT
from course.errors import UsageError


def next_exercise(desk: Desk) -> Exercise | None:
    """The one begun and not passed, else the first after it that is not passed, else any such; or None."""
    current = _current(desk)
    if current and not desk.is_passed(current.id):
        return current
    order = desk.course.exercises()
    at = next((place for place, one in enumerate(order) if current and one.id == current.id), -1)
    following = order[at + 1 :] + order[: at + 1]
    passed = desk.progress.passed_ids()
    return next((one for one in following if one.id not in passed), None)


def not_passed_yet(desk: Desk, exercise: Exercise) -> tuple[str, ...]:
    """The exercises whose work this one stands on and that are not passed."""
    passed = desk.progress.passed_ids()
    return tuple(needed for needed in exercise.requires if needed not in passed)


def chapter_text(exercise: Exercise) -> str:
    """The lesson of the exercise's chapter; no other chapter is read for it."""
    return read_text(exercise.folder / LESSON_TEXT)


def _current(desk: Desk) -> Exercise | None:
    name = desk.progress.current()
    try:
        return desk.course.exercise(name) if name else None
    except UsageError:  # the progress is of another course, or the exercise is gone from this one
        return None

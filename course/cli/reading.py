"""Which exercise comes next, and what is to be read with it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from course.cli.desk import Desk
from course.content import Exercise, Lesson, answers_file
from course.errors import UsageError

if TYPE_CHECKING:
    from rich.console import Console

    from course.content.question import Question


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


def unread(desk: Desk, lessons: Iterable[Lesson]) -> Iterator[Lesson]:
    """Those that were not shown yet; each counts as shown once the next one is asked for."""
    for lesson in lessons:
        if not desk.progress.chapter_shown(lesson.chapter.slug):
            yield lesson
            desk.progress.mark_chapter_shown(lesson.chapter.slug)


def put_questions(console: Console, desk: Desk, exercise: Exercise) -> None:
    """The questions of a quiz, to read; nothing for other exercises."""
    questions = questions_of(desk, exercise)
    if questions:
        from course.report.questions import render_questions

        render_questions(console, questions)


def questions_of(desk: Desk, exercise: Exercise) -> tuple[Question, ...]:
    """The questions of a quiz as this learner is asked them; none for other exercises."""
    if not exercise.questions:
        return ()
    from course.grading.mystery.load import questions_for
    from course.grading.quiz.order import as_seen

    seed = desk.home.seed()
    return as_seen(questions_for(exercise, seed), exercise.id, seed)


def right_answers_of(desk: Desk, exercise: Exercise) -> dict[str, str]:
    """The file of right answers to an exercise's questions, by its path; nothing without questions."""
    if not exercise.questions:
        return {}
    from course.grading.quiz.right import right_answers
    from course.grading.quiz.writing import answers_text

    questions = questions_of(desk, exercise)
    text = answers_text(exercise.id, questions, right_answers(questions))
    return {answers_file(exercise.id): text}


def _current(desk: Desk) -> Exercise | None:
    name = desk.progress.current()
    try:
        return desk.course.exercise(name) if name else None
    except UsageError:  # the progress is of another course, or the exercise is gone from this one
        return None

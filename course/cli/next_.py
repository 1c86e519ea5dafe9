"""`next`: the next exercise, ready to be worked on."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import nullcontext
from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.init import home_or_new
from course.cli.options import options_of
from course.cli.session import (
    REVIEW_AFTER,
    CourseSession,
    Pager,
    complete_exercise,
    next_exercise,
    not_passed_yet,
    open_session,
    unread,
)
from course.cli.usage import examples, typed
from course.home import begin
from course.report.console import open_console, paged, put_course_passed, put_steps
from course.report.exercise_text import put_requires, render_exercise, render_lesson, render_new_files

if TYPE_CHECKING:
    from rich.console import Console

    from course.content import Exercise

EXAMPLES = examples(
    ("next", "begin, or continue where you left off"),
    ("next --lesson", "with its part of the lesson again"),
    ("next 18-publisher", "go to this exercise"),
    ("--home ~/ros2 next", "in another course home"),
)


def next_(
    ctx: typer.Context,
    exercise: Annotated[
        str | None,
        typer.Argument(
            metavar="ID",
            help="The exercise to go to; by default, the first one you have not passed.",
            autocompletion=complete_exercise,
            show_default=False,
        ),
    ] = None,
    lesson: Annotated[bool, typer.Option("--lesson", help="Show its part of the lesson again.")] = False,
    pager: Pager = False,
) -> None:
    """Show the next exercise and put its files in place.

    Creates a course home if there is none. Shows each part of a lesson the first
    time. Files that already exist are never changed.
    """
    console = open_console()
    with open_session(ctx, home_or_new(console, options_of(ctx))) as session:
        chosen = session.course.exercise(exercise) if exercise else next_exercise(session)
        if chosen is None:
            _congratulate(console, session)
        else:
            with paged(console) if pager else nullcontext():
                _begin(console, session, chosen, lesson=lesson)


def _begin(console: Console, session: CourseSession, exercise: Exercise, *, lesson: bool) -> None:
    new = begin(session.home, exercise)
    session.progress.set_current(exercise.id)
    lessons = session.course.lessons(exercise)
    for shown in lessons if lesson else unread(session, lessons):
        render_lesson(console, shown.chapter, shown.text)
    render_exercise(console, exercise, session.home.path, session.progress.state(exercise.id))
    render_new_files(console, session.home.path, new)
    put_requires(console, not_passed_yet(session, exercise))
    steps = list(_steps(exercise))
    if _after_a_block(session, exercise):
        steps.insert(0, (typed("review"), "to answer a few earlier questions again, before you go on"))
    put_steps(console, steps)


def _after_a_block(session: CourseSession, exercise: Exercise) -> bool:
    """Whether it is the first exercise after another REVIEW_AFTER chapters, and has not been tried yet."""
    order = session.course.exercises()
    at = next(place for place, one in enumerate(order) if one.id == exercise.id)
    before = order[at - 1].chapter.number if at else exercise.chapter.number
    another = (before - 1) // REVIEW_AFTER < (exercise.chapter.number - 1) // REVIEW_AFTER
    return another and session.progress.state(exercise.id) == "begun"


def _steps(exercise: Exercise) -> Iterator[tuple[str, str]]:
    is_quiz = bool(exercise.questions) and not exercise.packages
    if exercise.play:
        yield typed("play"), "to start the nodes that you will explore, in a separate terminal"
    if exercise.play or not is_quiz:
        yield typed("shell"), "for a shell in your course home, with ROS 2 ready"
    if is_quiz:
        yield typed("check"), f"to answer {_questions(exercise)}"
    else:
        yield typed("check"), "when you have written it"
    if exercise.hints:
        yield typed("hint"), "when you are stuck"


def _questions(exercise: Exercise) -> str:
    count = len(exercise.questions)
    return "its question" if count == 1 else f"its {count} questions"


def _congratulate(console: Console, session: CourseSession) -> None:
    for shown in unread(session, session.course.last_lessons()):
        render_lesson(console, shown.chapter, shown.text)
    put_course_passed(console)
    put_steps(console, [(typed("list"), "to look back"), (typed("next ID"), "to do one of them again")])

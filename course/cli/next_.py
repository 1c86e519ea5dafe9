"""`next`: the next exercise, ready to be worked on."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import nullcontext
from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.arguments import Pager, complete_exercise
from course.cli.words import examples, typed

if TYPE_CHECKING:
    from rich.console import Console

    from course.cli.desk import Desk
    from course.content import Exercise

EXAMPLES = examples(
    ("next", "begin, or go on where you left off"),
    ("next --lesson", "with the chapter's lesson once more"),
    ("next 18-publisher", "go to this exercise"),
    ("--home ~/ros2 next", "in another course home"),
)


def next_(
    ctx: typer.Context,
    exercise: Annotated[
        str | None,
        typer.Argument(
            metavar="ID",
            help="Go to this exercise; without it, the first one not passed.",
            autocompletion=complete_exercise,
            show_default=False,
        ),
    ] = None,
    lesson: Annotated[bool, typer.Option("--lesson", help="Show the chapter's lesson again.")] = False,
    pager: Pager = False,
) -> None:
    """Show the next exercise and lay its first files.

    Makes a course home when there is none. A chapter's lesson is shown the
    first time. A file that is there already is never changed.
    """
    from course.cli.desk import open_desk
    from course.cli.homes import home_or_new
    from course.cli.options import options_of
    from course.cli.reading import next_exercise
    from course.report.console import open_console, paged

    console = open_console()
    with open_desk(ctx, home_or_new(console, options_of(ctx))) as desk:
        chosen = desk.course.exercise(exercise) if exercise else next_exercise(desk)
        if chosen is None:
            _congratulate(console, desk)
        else:
            with paged(console) if pager else nullcontext():
                _begin(console, desk, chosen, lesson=lesson)


def _begin(console: Console, desk: Desk, exercise: Exercise, *, lesson: bool) -> None:
    from course.cli.reading import not_passed_yet, unread
    from course.home import begin
    from course.report.console import put_steps
    from course.report.lesson import put_requires, render_exercise, render_lesson, render_new_files

    new = begin(desk.home, exercise)
    desk.progress.set_current(exercise.id)
    lessons = desk.course.lessons(exercise)
    for shown in lessons if lesson else unread(desk, lessons):
        render_lesson(console, shown.chapter, shown.text)
    render_exercise(console, exercise, desk.home.path, desk.progress.state(exercise.id))
    render_new_files(console, desk.home.path, new)
    put_requires(console, not_passed_yet(desk, exercise))
    put_steps(console, list(_steps(exercise)))


def _steps(exercise: Exercise) -> Iterator[tuple[str, str]]:
    is_quiz = bool(exercise.questions) and not exercise.packages
    if exercise.play:
        yield typed("play"), "to start what is to be explored, in a terminal of its own"
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


def _congratulate(console: Console, desk: Desk) -> None:
    from course.cli.reading import unread
    from course.report.console import put, put_steps
    from course.report.lesson import render_lesson

    for shown in unread(desk, desk.course.last_lessons()):
        render_lesson(console, shown.chapter, shown.text)
    put(console, "You have passed every exercise of this course. Well done!", "bold green")
    put(console)
    put_steps(console, [(typed("list"), "to look back"), (typed("next ID"), "to do one of them again")])

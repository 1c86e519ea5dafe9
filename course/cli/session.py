"""What a command works with: the course, the course home, what has been reached, and shared arguments."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Annotated

import typer

from course.cli.options import Options, options_of
from course.cli.usage import typed
from course.content import Course, Exercise, Lesson, open_course
from course.errors import CourseError, UsageError
from course.files import cache_dir
from course.home import CourseHome, find_home, remembered_course, starter_files
from course.progress import Progress
from course.report.console import error_console
from course.report.problem import render_notice


@dataclass(frozen=True)
class CourseSession:
    """An opened course, the course home it is worked on in, and what has been reached."""

    course: Course
    home: CourseHome
    progress: Progress

    def exercise(self, name: str | None) -> Exercise:
        """The named exercise, or else the current one."""
        wanted = name or self.progress.current()
        if wanted is None:
            raise UsageError("You have not begun an exercise yet.", f"`{typed('next')}` opens the first one.")
        return self.course.exercise(wanted)

    def is_passed(self, exercise: str) -> bool:
        return self.progress.state(exercise) == "passed"


def course_of(options: Options) -> Course:
    return open_course(options.course, cache=cache_dir(os.environ) / "lessons")


def course_here(options: Options) -> Course:
    """The given course, else that of the current course home, else the one that comes with `ros2course`."""
    try:
        return course_of_home(options, home_of(options))
    except UsageError:
        return course_of(options)


def course_of_home(options: Options, home: CourseHome) -> Course:
    """The given course, or else the one for which the home was made."""
    return course_of(Options(options.home, options.course or remembered_course(home)))


def home_of(options: Options) -> CourseHome:
    return find_home(options.home)


@contextmanager
def open_session(ctx: typer.Context, home: CourseHome | None = None) -> Iterator[CourseSession]:
    """Open everything for one command, and pass on what the progress file has to say.

    The course is the one given, else the one that the course home was made for.
    """
    options = options_of(ctx)
    given = course_of(options) if options.course else None  # report a wrong course before a missing home
    home = home or home_of(options)
    course = given or course_of_home(options, home)
    with Progress.open(home.state) as progress:
        for notice in progress.notices:
            render_notice(error_console(), notice)
        yield CourseSession(course, home, progress)


REVIEW_AFTER = 4  # chapters between two suggestions of a review


def next_exercise(session: CourseSession) -> Exercise | None:
    """The current exercise if not passed, else the next one not passed, else any such one; or None."""
    current = _current(session)
    if current and not session.is_passed(current.id):
        return current
    order = session.course.exercises()
    at = next((place for place, one in enumerate(order) if current and one.id == current.id), -1)
    following = order[at + 1 :] + order[: at + 1]
    passed = session.progress.passed_ids()
    return next((one for one in following if one.id not in passed), None)


def not_passed_yet(session: CourseSession, exercise: Exercise) -> tuple[str, ...]:
    """The exercises on which this one builds, that are not passed, and whose files it does not supply."""
    passed, supplied = session.progress.passed_ids(), {*starter_files(exercise)}
    needed = [session.course.exercise(one) for one in exercise.requires if one not in passed]
    return tuple(one.id for one in needed if not one.files or not supplied.issuperset(one.files))


def unread(session: CourseSession, lessons: Iterable[Lesson]) -> Iterator[Lesson]:
    """The lessons not shown yet; each counts as shown once the next one is asked for."""
    for lesson in lessons:
        if not session.progress.chapter_shown(lesson.id):
            yield lesson
            session.progress.mark_chapter_shown(lesson.id)


def _current(session: CourseSession) -> Exercise | None:
    name = session.progress.current()
    try:
        return session.course.exercise(name) if name else None
    except UsageError:  # the progress belongs to another course, or the exercise is gone
        return None


def complete_exercise(ctx: typer.Context, incomplete: str) -> list[tuple[str, str]]:
    """Exercise ids with their titles. During completion, an error only means that there are none."""
    try:
        exercises = course_here(options_of(ctx)).exercises()
    except CourseError:
        return []
    return [(one.id, one.title) for one in exercises if one.id.startswith(incomplete)]


ExerciseId = Annotated[
    str,
    typer.Argument(
        metavar="ID",
        help="The exercise, such as 18-publisher; a part of the id is enough if only one matches.",
        autocompletion=complete_exercise,
    ),
]
CurrentExercise = Annotated[
    str | None,
    typer.Argument(
        metavar="ID",
        help="The exercise, such as 18-publisher; a part of the id is enough if only one matches. "
        "Without it, your current exercise.",
        autocompletion=complete_exercise,
        show_default=False,
    ),
]
GradingJobs = Annotated[
    int | None,
    typer.Option("--jobs", min=1, max=64, help="How many to grade at once; by default, four per core."),
]
Pager = Annotated[bool, typer.Option("--pager", help="Show the text one screen at a time.")]

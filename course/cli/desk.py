"""What nearly every command needs: the course, the learner's course home and the progress in it."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

import typer

from course.cli.options import Options, options_of
from course.cli.words import typed
from course.content import Course, Exercise, open_course
from course.errors import UsageError
from course.home import CourseHome, find_home, remembered_course
from course.progress import Progress
from course.report.console import error_console
from course.report.problem import render_notice
from course.rosenv.paths import cache_dir


@dataclass(frozen=True)
class Desk:
    """An opened course, the course home it is worked on in, and what has been reached."""

    course: Course
    home: CourseHome
    progress: Progress

    def exercise(self, name: str | None) -> Exercise:
        """The exercise named, else the one that the learner is at."""
        wanted = name or self.progress.current()
        if wanted is None:
            raise UsageError("No exercise has been begun yet.", f"`{typed('next')}` begins the first one.")
        return self.course.exercise(wanted)

    def is_passed(self, exercise: str) -> bool:
        return self.progress.state(exercise) == "passed"


def course_of(options: Options) -> Course:
    return open_course(options.course, cache=cache_dir(os.environ) / "lessons")


def course_here(options: Options) -> Course:
    """The course given, else that of the course home one would work in, else the one that comes along."""
    try:
        return course_of_home(options, home_of(options))
    except UsageError:
        return course_of(options)


def course_of_home(options: Options, home: CourseHome) -> Course:
    """The course given, else the one that the home was made for."""
    return course_of(replace(options, course=options.course or remembered_course(home)))


def home_of(options: Options) -> CourseHome:
    return find_home(options.home, os.environ, _here())


def _here() -> Path:
    try:
        return Path.cwd()
    except FileNotFoundError:
        raise UsageError(
            "The folder you are in does not exist any more.", "Go to another one: `cd`"
        ) from None


@contextmanager
def open_desk(ctx: typer.Context, home: CourseHome | None = None) -> Iterator[Desk]:
    """Open everything for one command, and pass on what the progress file has to say.

    The course is the one given, else the one that the course home was made for.
    """
    options = options_of(ctx)
    given = course_of(options) if options.course else None  # a wrong one is told of before a missing home
    home = home or home_of(options)
    course = given or course_of_home(options, home)
    with Progress.open(home.state) as progress:
        for notice in progress.notices:
            render_notice(error_console(), notice)
        yield Desk(course, home, progress)

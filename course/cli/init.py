"""`init`: make a course home."""

from __future__ import annotations

import contextlib
import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.options import Options, options_of
from course.cli.session import home_of
from course.cli.shell import setup_line
from course.cli.usage import examples, typed
from course.content.layout import require_course
from course.errors import MissingHere, UsageError
from course.home import CourseHome, create_home, default_home, is_home, remember_course
from course.report.console import open_console, put, put_steps
from course.report.exercise_text import render_new_home

if TYPE_CHECKING:
    from rich.console import Console


EXAMPLES = examples(
    ("init", "a course home in ~/ros2course"),
    ("init ~/ros2", "in another folder"),
    ("init .", "in the folder you are in"),
)


def init(
    ctx: typer.Context,
    folder: Annotated[
        Path | None,
        typer.Argument(
            metavar="DIR", help="The folder; it is created if it does not exist.", show_default=False
        ),
    ] = None,
) -> None:
    """Create a course home, the folder that you work in.

    Files that already exist are not changed. With --course, commands in this
    home use that course from then on.
    """
    console = open_console()
    options = options_of(ctx)
    make_home(console, folder or place_for(options), options.course)
    _show_setup_line(console)
    put_steps(console, [(typed("next"), "to begin"), (typed("shell"), "for a shell in it, with ROS 2 ready")])


def _show_setup_line(console: Console) -> None:
    # A home can be made without ROS 2; the first check says what is missing.
    with contextlib.suppress(MissingHere):
        line = setup_line()
        put(console, f"For later, the line that sets up ROS 2 in a terminal:\n  {line}\n")


def place_for(options: Options) -> Path:
    """Where a new course home belongs: the given folder, or else ~/ros2course."""
    told = options.home or os.environ.get("ROS2COURSE_HOME")
    return Path(told).expanduser() if told else default_home(os.environ)


def home_or_new(console: Console, options: Options) -> CourseHome:
    """The course home. If there is none, makes one and says so."""
    try:
        return home_of(options)
    except UsageError:
        return make_home(console, place_for(options), options.course)


def make_home(console: Console, place: Path, course: Path | None = None) -> CourseHome:
    """Make a course home, or add missing files to one, and say which of the two it did.

    course: the folder of the course that it is for from now on; None for ros2course's own.
    """
    if course is not None:
        require_course(course)
    was_there = is_home(place)
    home = create_home(place)
    if course is not None:
        remember_course(home, course)
    render_new_home(console, home.path, was_there=was_there, course=course)
    return home

"""Finding the course home for a command that may make one."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from course.cli.desk import home_of
from course.cli.options import Options
from course.content.layout import require_course
from course.errors import UsageError
from course.home import CourseHome, create_home, default_home, is_home, remember_course

if TYPE_CHECKING:
    from rich.console import Console


def place_for(options: Options) -> Path:
    """Where a new course home belongs: as told, else ~/ros2course."""
    told = options.home or os.environ.get("ROS2COURSE_HOME")
    return Path(told).expanduser() if told else default_home(os.environ)


def home_or_new(console: Console, options: Options) -> CourseHome:
    """The course home, made first where there is none; says so when it does."""
    try:
        return home_of(options)
    except UsageError:
        return make_home(console, place_for(options), options.course)


def make_home(console: Console, place: Path, course: Path | None = None) -> CourseHome:
    """Make a course home, or add what one lacks, and say which of the two it was.

    course: the folder of the course that it is for from now on, unless it is the one that comes along.
    """
    from course.report.lesson import render_new_home

    if course is not None:
        require_course(course)
    was_there = is_home(place)
    home = create_home(place)
    if course is not None:
        remember_course(home, course)
    render_new_home(console, home.path, was_there=was_there, course=course)
    return home

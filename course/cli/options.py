"""The options that every command has."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import typer

if TYPE_CHECKING:
    from course.grading.supervisor import ForkServer


@dataclass(frozen=True)
class Options:
    """`home` and `course` (its folder) as given on the command line, or None. fork_server: of `check`."""

    home: Path | None = None
    course: Path | None = None
    fork_server: ForkServer | None = None


def options_of(ctx: typer.Context) -> Options:
    """The options of this call. Completion asks for them before the program's callback has run."""
    if isinstance(ctx.obj, Options):
        return ctx.obj
    given = ctx.find_root().params
    return Options(home=_path(given.get("home")), course=course_named(given.get("course")))


def course_named(value: object) -> Path | None:
    """The folder of the course that --course names. Raises UsageError when there is none of that name."""
    from course.content.layout import named_course

    return named_course(str(value)) if value else None


def _path(value: object) -> Path | None:
    """During completion, a value may still be the typed text."""
    return Path(str(value)) if value else None

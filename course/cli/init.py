"""`init`: make a course home."""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.words import examples, typed
from course.errors import MissingHere

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
        typer.Argument(metavar="DIR", help="Where; it is made if need be.", show_default=False),
    ] = None,
) -> None:
    """Make a course home, the folder in which you work.

    Nothing that is there already is changed. With --course, commands in it are
    about that course from then on.
    """
    from course.cli.homes import make_home, place_for
    from course.cli.options import options_of
    from course.report.console import open_console, put_steps

    console = open_console()
    options = options_of(ctx)
    make_home(console, folder or place_for(options), options.course)
    _show_setup_line(console)
    put_steps(console, [(typed("next"), "to begin"), (typed("shell"), "for a shell in it, with ROS 2 ready")])


def _show_setup_line(console: Console) -> None:
    from course.cli.shell import setup_line
    from course.report.console import put

    # Without a ROS 2 there is a home all the same; the first check says what is missing.
    with contextlib.suppress(MissingHere):
        line = setup_line()
        put(console, f"The line that makes ROS 2 ready in a terminal, for later:\n  {line}\n")

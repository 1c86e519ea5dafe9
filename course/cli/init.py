"""`init`: make a course home."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from course.cli.words import examples, typed

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

    Nothing that is there already is changed.
    """
    from course.cli.homes import make_home, place_for
    from course.cli.options import options_of
    from course.report.console import open_console, put_steps

    console = open_console()
    make_home(console, folder or place_for(options_of(ctx)))
    put_steps(console, [(typed("next"), "to begin"), (typed("shell"), "for a shell in it, with ROS 2 ready")])

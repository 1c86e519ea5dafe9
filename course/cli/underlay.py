"""`build-underlay`: build now what is otherwise built at first need."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.words import examples
from course.errors import UsageError

if TYPE_CHECKING:
    from course.rosenv import Ros

EXAMPLES = examples(
    ("build-underlay", "all of them, ahead of time"),
    ("build-underlay example_interfaces", "one package"),
)


def build_underlay(
    packages: Annotated[
        list[str] | None,
        typer.Argument(metavar="[PACKAGE]...", help="All if none is given."),
    ] = None,
) -> None:
    """Build the ROS packages that come with the course.

    ROS 2 from pip lacks some; an installed one is complete. You need not call
    this: what first asks for such a package builds it, in up to two minutes.
    """
    from course.build.underlay import build_underlay as build
    from course.report.activity import activity
    from course.report.console import error_console
    from course.rosenv import find_ros, prepare

    ros = find_ros()
    prepare(ros)
    names = _known(packages, ros)
    if not names:
        print("Nothing is missing.")
        return
    with activity(error_console(), f"Building {', '.join(names)}, this once") as say:
        build(names, ros, on_progress=say)


def _known(wanted: list[str] | None, ros: Ros) -> list[str]:
    """The names to build: those that were asked for, or whatever is missing."""
    from course.rosenv import compiled_of_underlay, missing_of_underlay

    if not wanted:
        return [package.name for package in missing_of_underlay(ros)]
    known = [package.name for package in compiled_of_underlay(ros)]
    for name in wanted:
        if name not in known:
            step = f"There are: {', '.join(known)}." if known else "This ROS 2 is complete."
            raise UsageError(f"The course brings no package {name} that must be built.", step)
    return wanted

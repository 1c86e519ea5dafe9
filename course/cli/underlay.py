"""`build-underlay`: builds packages now that would otherwise be built when first needed."""

from __future__ import annotations

from typing import Annotated

import typer

from course.build.underlay_build import build_underlay as build
from course.cli.usage import examples
from course.errors import UsageError
from course.report.activity import activity
from course.report.console import error_console
from course.rosenv import Ros, compiled_of_underlay, find_ros, missing_of_underlay, prepare

EXAMPLES = examples(
    ("build-underlay", "all of them, ahead of time"),
    ("build-underlay example_interfaces", "one package"),
)


def build_underlay(
    packages: Annotated[
        list[str] | None,
        typer.Argument(metavar="[PACKAGE]...", help="By default, all of them."),
    ] = None,
) -> None:
    """Build the ROS packages that come with the course.

    ROS 2 from pip lacks some packages; an installed ROS 2 is complete. You don't
    have to run this: the first command that needs such a package builds it, in
    up to two minutes.
    """
    ros = find_ros()
    prepare(ros)
    names = _known(packages, ros)
    if not names:
        print("Nothing is missing.")
        return
    with activity(error_console(), f"Building {', '.join(names)}, only this once") as say:
        build(names, ros, on_progress=say)


def _known(wanted: list[str] | None, ros: Ros) -> list[str]:
    if not wanted:
        return [package.name for package in missing_of_underlay(ros)]
    known = [package.name for package in compiled_of_underlay(ros)]
    for name in wanted:
        if name not in known:
            step = f"There are: {', '.join(known)}." if known else "This ROS 2 is complete."
            raise UsageError(f"The course has no package {name} that must be built.", step)
    return wanted

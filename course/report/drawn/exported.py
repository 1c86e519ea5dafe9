"""A recording that was copied out of the course home, and what opens it."""

from __future__ import annotations

from pathlib import Path

from rich.console import Console

from course.report import safe
from course.report.console import put, put_prose
from course.report.drawn.summary import bytes_of


def render_exported(console: Console, exercise: str, target: Path, size: int) -> None:
    """Where it is now, how large, and how to look at it."""
    put(console, f"{safe.one_line(str(target))}  {bytes_of(size)}", "bold")
    put_prose(console, f"The recording of the last check of {safe.one_line(exercise)}. To look at it:")
    for program, how in (
        ("Foxglove", "«Open local file», then this file; a panel «Plot» or «Raw Messages» for a topic."),
        ("PlotJuggler", "drop the file into its window, choose topics, drag a field into the plot."),
    ):
        put_prose(console, f"{program}: {how}", first="  ", rest="    ")
    put_prose(
        console,
        "Beside the messages it holds a topic of its own, /ros2course/events: programs, signals, services "
        "and the graph, each as JSON in a text; and your files, as attachments.",
    )

"""A recording in the terminal: a summary of its content, pictures, and a copy for other programs."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

from rich.console import Console
from rich.text import Text

from course.evidence.recording import Recording
from course.model.events import MessageSeen, MessageSent, ProcessStarted
from course.model.graph import infrastructure
from course.model.result import Result
from course.report import sanitize
from course.report.console import put, put_prose
from course.report.pictures.graph_text import render_graph
from course.report.pictures.lanes import Told, duration_of
from course.report.pictures.plot_text import Band, render_plot
from course.report.pictures.signals import Signal, intervals_of, latencies_of, signals_of
from course.report.pictures.timeline_text import rate, render_line

SECRET = "The recording of a mystery is not shown: it contains what you should find out."


def render_pictures(console: Console, recording: Recording, result: Result | None) -> None:
    """The timeline, signals, and who talks to whom. Nothing for a mystery.

    result: what the checks said about this recording, if that is known.
    """
    if is_secret(recording):
        put_prose(console, SECRET)
        return
    told = Told.by(result)
    render_line(console, recording, told)
    for signal, band in _signals(recording, told):
        put(console)
        render_plot(console, signal, duration_of(recording), band)
    if recording.graphs:
        put(console)
        render_graph(console, recording, told)


def render_recording(console: Console, recording: Recording, size: int, result: Result | None) -> None:
    """A summary of its content, then its pictures. size: of its file, in bytes."""
    if not is_secret(recording):
        render_summary(console, recording, size)
        put(console)
    render_pictures(console, recording, result)


def is_secret(recording: Recording) -> bool:
    """Whether it contains the names that a learner should find out."""
    return recording.seed is not None or bool(recording.acts)


def belongs(result: Result | None, recording: Recording) -> bool:
    """Whether these checks judged this recording: no two recordings have exactly the same duration."""
    return result is not None and result.timing.evidence == round(recording.duration, 3) > 0


def _signals(recording: Recording, told: Told) -> Iterator[tuple[Signal, Band | None]]:
    drawn = list(signals_of(recording))
    paced = [(intervals_of(recording, pace.topic), (pace.shortest, pace.longest)) for pace in told.paces]
    yield from ((signal, None) for signal in drawn if not (signal.unit and paced))
    yield from ((signal, band) for signal, band in paced if signal)
    answers = latencies_of(recording)
    if answers:
        yield answers, None


_MOST = 20
_NAME = 60


def render_summary(console: Console, recording: Recording, size: int) -> None:
    """size: of its file, in bytes."""
    name = sanitize.one_line(recording.exercise, _NAME)
    head = Text.assemble((name, "bold"), f": {recording.duration:.1f} s recorded, {bytes_of(size)}")
    put_prose(console, head)
    for title, lines in (
        ("Messages", list(_topics(recording))),
        ("Programs", list(_programs(recording))),
    ):
        if lines:
            put(console, title, "bold")
        for line in lines[:_MOST]:
            put_prose(console, line, first="  ", rest="      ")
        if len(lines) > _MOST:
            put(console, f"  ... {len(lines) - _MOST} more ...", "dim")


def bytes_of(size: int) -> str:
    """`812 bytes`, `16 kB`, `3.1 MB`."""
    if size < 1000:
        return f"{size} bytes"
    return f"{size / 1000:.0f} kB" if size < 1_000_000 else f"{size / 1_000_000:.1f} MB"


def _topics(recording: Recording) -> Iterator[Text]:
    times: defaultdict[tuple[str, str, bool], list[float]] = defaultdict(list)
    for event in recording.events:
        if isinstance(event, MessageSeen | MessageSent) and not infrastructure(event.topic):
            times[event.topic, event.type, isinstance(event, MessageSent)].append(event.t)
    for (topic, type_name, sent), at in sorted(times.items()):
        pace = "" if sent else rate(tuple(at))
        count = f"{len(at)} message{'s' if len(at) != 1 else ''}{' sent by the grader' if sent else ''}"
        parts = [count, *([pace] if pace else []), sanitize.one_line(type_name, _NAME)]
        yield Text.assemble((sanitize.one_line(topic, _NAME), "cyan"), f": {', '.join(parts)}")


def _programs(recording: Recording) -> Iterator[Text]:
    started = (event.process for event in recording.events if isinstance(event, ProcessStarted))
    for name in dict.fromkeys(started):
        yield Text.assemble((sanitize.one_line(name, _NAME), "cyan"), f": {_end(recording, name)}")


def _end(recording: Recording, name: str) -> str:
    view = recording.process(name)
    if view.exited is None:
        return "still ran at the end"
    how = (
        f"signal {view.exited.signal}" if view.exited.signal is not None else f"exit code {view.exited.code}"
    )
    by_itself = ", by itself" if view.ended_by_itself else ""
    return f"ended with {how} after {view.lifetime or 0:.1f} s{by_itself}"


def render_exported(console: Console, exercise: str, target: Path, size: int) -> None:
    """Where the file is, how large it is, and how to look at it."""
    put(console, f"{sanitize.one_line(str(target))}  {bytes_of(size)}", "bold")
    put_prose(console, f"The recording of the last check of {sanitize.one_line(exercise)}. To look at it:")
    for program, how in (
        ("Foxglove", '"Open local file", then this file; a panel "Plot" or "Raw Messages" for a topic.'),
        ("PlotJuggler", "drop the file into its window, choose topics, drag a field into the plot."),
    ):
        put_prose(console, f"{program}: {how}", first="  ", rest="    ")
    put_prose(
        console,
        "In addition to the messages, it contains a topic /ros2course/events: programs, signals, services "
        "and the graph, each as JSON in a string. Your files are attachments.",
    )

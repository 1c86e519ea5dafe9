"""All pictures of one recording, in the terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.console import Console

from course.evidence.recording import Recording
from course.grading.result import Result
from course.report.console import put, put_prose
from course.report.drawn.graph import render_graph
from course.report.drawn.line import render_line
from course.report.drawn.plot import Band, render_plot
from course.report.drawn.summary import render_summary
from course.report.drawn.told import Told
from course.report.pictures.lanes import duration_of
from course.report.pictures.signals import Signal, intervals_of, latencies_of, signals_of

SECRET = "The recording of a mystery is not shown: what you are to find out stands in it."


def render_pictures(console: Console, recording: Recording, result: Result | None) -> None:
    """The time line, signals, and who talks to whom. None of a mystery.

    result: what the checks said of this recording, where that is known.
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
    """What is in it in words, then its pictures. size: of its file, in bytes."""
    if not is_secret(recording):
        render_summary(console, recording, size)
        put(console)
    render_pictures(console, recording, result)


def is_secret(recording: Recording) -> bool:
    """Whether it holds the names that a learner is to find out."""
    return recording.seed is not None or bool(recording.acts)


def belongs(result: Result | None, recording: Recording) -> bool:
    """Whether these checks judged this recording: how long it took is never the same twice."""
    return result is not None and result.timing.evidence == round(recording.duration, 3) > 0


def _signals(recording: Recording, told: Told) -> Iterator[tuple[Signal, Band | None]]:
    """Values in messages; the time between those that a pace was asked of, else of the most; latencies."""
    drawn = list(signals_of(recording))
    paced = [(intervals_of(recording, pace.topic), (pace.shortest, pace.longest)) for pace in told.paces]
    yield from ((signal, None) for signal in drawn if not (signal.unit and paced))
    yield from ((signal, band) for signal, band in paced if signal)
    answers = latencies_of(recording)
    if answers:
        yield answers, None

"""What is in a recording, in a few lines: topics, types, counts and rates; programs and their ends."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from rich.console import Console
from rich.text import Text

from course.evidence.events import MessageSeen, MessageSent, ProcessStarted
from course.evidence.graph import infrastructure
from course.evidence.recording import Recording
from course.report import safe
from course.report.console import put, put_prose
from course.report.drawn.line import rate

_MOST = 20
_NAME = 60


def render_summary(console: Console, recording: Recording, size: int) -> None:
    """size: of its file, in bytes."""
    name = safe.one_line(recording.exercise, _NAME)
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
    """As people write it: `812 bytes`, `16 kB`, `3.1 MB`."""
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
        parts = [count, *([pace] if pace else []), safe.one_line(type_name, _NAME)]
        yield Text.assemble((safe.one_line(topic, _NAME), "cyan"), f": {', '.join(parts)}")


def _programs(recording: Recording) -> Iterator[Text]:
    started = (event.process for event in recording.events if isinstance(event, ProcessStarted))
    for name in dict.fromkeys(started):
        yield Text.assemble((safe.one_line(name, _NAME), "cyan"), f": {_end(recording, name)}")


def _end(recording: Recording, name: str) -> str:
    view = recording.process(name)
    if view.exited is None:
        return "still ran at the end"
    how = (
        f"signal {view.exited.signal}" if view.exited.signal is not None else f"exit code {view.exited.code}"
    )
    by_itself = ", by itself" if view.ended_by_itself else ""
    return f"ended with {how} after {view.lifetime or 0:.1f} s{by_itself}"

"""What `ros2 launch` started, told apart by the names that it puts before their lines."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from course.evidence.events import Event, OutputLine, ProcessExited, ProcessLeft, ProcessStarted
from course.evidence.process_view import ProcessView

# Source: launch.actions.ExecuteLocal of ROS 2, which says this of every process.
_STARTED = re.compile(r"^\[INFO\] \[(?P<name>[^\]]+-\d+)\]: process started with pid \[\d+\]")
_ENDED = re.compile(
    r"^\[(?:INFO|ERROR)\] \[(?P<name>[^\]]+-\d+)\]: process has "
    r"(?:finished cleanly|died \[pid \d+, exit code (?P<code>-?\d+))"
)
_SAID = re.compile(r"^\[(?P<name>[^\] ]+-\d+)\] ?(?P<text>.*)$")
_ERROR = re.compile(r"^\[ERROR\] \[launch\]: (?P<text>.*)$")
# A launch file that cannot be read: one line for each way of reading it; the first was as Python.
_REASON = " - "


@dataclass(frozen=True)
class LaunchView:
    """One run of a launch file.

    main: `ros2 launch` itself, with every line. processes: what it started, by the name that
    launch gives it (`talker-1`), each with its own lines. left: what still ran after Ctrl+C had
    ended `ros2 launch`.
    """

    main: ProcessView
    processes: Mapping[str, ProcessView]
    left: tuple[ProcessLeft, ...]

    @classmethod
    def of(cls, name: str, events: tuple[Event, ...]) -> LaunchView:
        main = ProcessView.of(name, events)
        names = dict.fromkeys(found["name"] for line, found in _found(_STARTED, main))
        left = (event for event in events if isinstance(event, ProcessLeft) and event.process == name)
        return cls(main, {one: _process(one, main) for one in names}, tuple(left))

    @property
    def error(self) -> str | None:
        """What `ros2 launch` itself complains of: launch's own words, or the end of its traceback."""
        said = next((found["text"] for _, found in _found(_ERROR, self.main)), None)
        own = tuple(line for line in self.main.lines if not _SAID.match(line.text))
        if said and said.endswith(":"):
            reasons = (line.text for line in own if line.text.startswith(_REASON))
            return next(reasons, said).removeprefix(_REASON)
        trace = replace(self.main, lines=own).traceback()
        return said or (trace[-1] if trace else None)

    @property
    def tracebacks(self) -> dict[str, tuple[str, ...]]:
        """Of the launched processes that printed one, the last traceback by their names."""
        found = {name: view.traceback() for name, view in self.processes.items()}
        return {name: lines for name, lines in found.items() if lines}


def _process(name: str, main: ProcessView) -> ProcessView:
    started = (line for line, found in _found(_STARTED, main) if found["name"] == name)
    lines = (
        replace(line, process=name, text=found["text"])
        for line, found in _found(_SAID, main)
        if found["name"] == name
    )
    ended = (
        ProcessExited(line.t, name, *_status(found["code"]))
        for line, found in _found(_ENDED, main)
        if found["name"] == name
    )
    return ProcessView(
        name,
        next((ProcessStarted(line.t, name, ()) for line in started), None),
        tuple(lines),
        0,
        main.signals,
        next(ended, None),
    )


def _status(code: str | None) -> tuple[int | None, int | None]:
    """Exit code and signal; launch writes a signal as a negative code."""
    number = int(code or 0)
    return (None, -number) if number < 0 else (number, None)


def _found(pattern: re.Pattern[str], main: ProcessView) -> Iterator[tuple[OutputLine, re.Match[str]]]:
    for line in main.lines:
        match = pattern.match(line.text)
        if match:
            yield line, match

"""One program in a recording: its output, its end, and its tracebacks."""

from __future__ import annotations

import json
import re
import signal
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import takewhile
from typing import Any

from course.model import replace
from course.model.events import (
    Event,
    OutputCut,
    OutputLine,
    Probed,
    ProcessExited,
    ProcessLeft,
    ProcessStarted,
    ShellRan,
    ShellReady,
    ShellStuck,
    SignalSent,
)

_MORE = 4
_UNREADABLE = ("SyntaxError:", "IndentationError:", "TabError:")
TRACEBACK = "Traceback (most recent call last)"


@dataclass(frozen=True)
class ProcessView:
    """A program that the scenario ran. `started` is None if it never started.

    dropped: bytes of output that were beyond the limit and not kept.
    """

    name: str
    started: ProcessStarted | None
    lines: tuple[OutputLine, ...]
    dropped: int
    signals: tuple[SignalSent, ...]
    exited: ProcessExited | None

    @classmethod
    def of(cls, name: str, events: tuple[Event, ...]) -> ProcessView:
        own = [event for event in events if getattr(event, "process", None) == name]
        return cls(
            name,
            next((event for event in own if isinstance(event, ProcessStarted)), None),
            tuple(event for event in own if isinstance(event, OutputLine)),
            sum(event.dropped for event in own if isinstance(event, OutputCut)),
            tuple(event for event in own if isinstance(event, SignalSent)),
            next((event for event in own if isinstance(event, ProcessExited)), None),
        )

    @property
    def text(self) -> tuple[str, ...]:
        return tuple(line.text for line in self.lines)

    @property
    def interrupted_at(self) -> float | None:
        """When the scenario first sent SIGINT."""
        return next((sent.t for sent in self.signals if sent.signal == signal.SIGINT), None)

    @property
    def ended_by_itself(self) -> ProcessExited | None:
        """Its end, if we had not sent it a signal before."""
        if self.exited and not any(sent.t <= self.exited.t for sent in self.signals):
            return self.exited
        return None

    @property
    def lifetime(self) -> float | None:
        """Seconds from its start to its end; None if it has not ended."""
        if self.started and self.exited:
            return self.exited.t - self.started.t
        return None

    def traceback(self, after: float = 0.0) -> tuple[str, ...]:
        """Return the last Python traceback that it printed from time `after` (s) on; empty if it has none."""
        lines = [line.text for line in self.lines if line.t >= after]
        starts = [
            index
            for index, text in enumerate(lines)
            if TRACEBACK in text and not (index and lines[index - 1].startswith("Exception ignored in"))
        ]
        return _one_traceback(lines[starts[-1] :]) if starts else _unreadable_script(lines)


def _unreadable_script(lines: list[str]) -> tuple[str, ...]:
    """For a script that it cannot parse, Python leaves out the traceback's first line."""
    if not lines or not lines[-1].startswith(_UNREADABLE):
        return ()
    files = [index for index, text in enumerate(lines) if text.startswith('  File "')]
    return tuple(lines[files[-1] :]) if files else ()


def _one_traceback(lines: list[str]) -> tuple[str, ...]:
    """From its first line to the line with the exception, the first one that is not indented.

    An exception's message may continue on indented lines; a few of them are kept.
    """
    for index, text in enumerate(lines[1:], start=1):
        if text and not text.startswith((" ", "\t")):
            more = takewhile(lambda line: line.startswith((" ", "\t")), lines[index + 1 : index + 1 + _MORE])
            return (*lines[: index + 1], *more)
    return tuple(lines)


# Source: launch.actions.ExecuteLocal of ROS 2, which logs this for every process.
_STARTED = re.compile(r"^\[INFO\] \[(?P<name>[^\]]+-\d+)\]: process started with pid \[\d+\]")
_ENDED = re.compile(
    r"^\[(?:INFO|ERROR)\] \[(?P<name>[^\]]+-\d+)\]: process has "
    r"(?:finished cleanly|died \[pid \d+, exit code (?P<code>-?\d+))"
)
_SAID = re.compile(r"^\[(?P<name>[^\] ]+-\d+)\] ?(?P<text>.*)$")
_ERROR = re.compile(r"^\[ERROR\] \[launch\]: (?P<text>.*)$")
# For an unreadable launch file: one line per attempted format; the first is Python.
_REASON = " - "


@dataclass(frozen=True)
class LaunchView:
    """One run of a launch file.

    main: `ros2 launch` itself, with all of its output. processes: what it started, by the name that launch
    gives each (`talker-1`), each with its own lines. left: processes that were still running after Ctrl+C
    had ended `ros2 launch`.
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
        """The error that `ros2 launch` itself reports: its message, or the end of its traceback."""
        said = next((found["text"] for _, found in _found(_ERROR, self.main)), None)
        own = tuple(line for line in self.main.lines if not _SAID.match(line.text))
        if said and said.endswith(":"):
            reasons = (line.text for line in own if line.text.startswith(_REASON))
            return next(reasons, said).removeprefix(_REASON)
        trace = replace(self.main, lines=own).traceback()
        return said or (trace[-1] if trace else None)


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
    """Exit code and signal; launch reports a signal as a negative code."""
    number = int(code or 0)
    return (None, -number) if number < 0 else (number, None)


def _found(pattern: re.Pattern[str], main: ProcessView) -> Iterator[tuple[OutputLine, re.Match[str]]]:
    for line in main.lines:
        match = pattern.match(line.text)
        if match:
            yield line, match


@dataclass(frozen=True)
class ShellView:
    """A shell that the scenario opened.

    ready: set once it had read `~/.bashrc` and shown a prompt. ran: the commands in order. stuck: why a
    prompt did not appear; None if it always did.
    """

    name: str
    ready: ShellReady | None
    ran: tuple[ShellRan, ...]
    stuck: ShellStuck | None

    @classmethod
    def of(cls, name: str, events: tuple[Event, ...]) -> ShellView:
        own = [event for event in events if getattr(event, "process", None) == name]
        return cls(
            name,
            next((event for event in own if isinstance(event, ShellReady)), None),
            tuple(event for event in own if isinstance(event, ShellRan)),
            next((event for event in own if isinstance(event, ShellStuck)), None),
        )

    def command(self, text: str) -> ShellRan | None:
        """Return the first run of exactly this command; None if it was never typed."""
        return next((ran for ran in self.ran if ran.command == text), None)


@dataclass(frozen=True)
class ProbeAnswer:
    """The answer to one question of a probe; the question is "" if the probe itself failed.

    value: plain JSON data; anything else as its `repr`. type: the name of the value's type. error: the line
    that names the exception, if one was raised; `file` and `line` then say which line led to it. `file` is
    relative to the course home, or absolute outside of it; None if there is none.
    """

    question: str
    value: Any = None
    type: str = ""
    error: str | None = None
    file: str | None = None
    line: int | None = None


@dataclass(frozen=True)
class ProbeView:
    """A probe that the scenario ran. finished: False if it did not reach its end in time."""

    name: str
    ran: bool
    finished: bool
    answers: tuple[ProbeAnswer, ...]

    @classmethod
    def of(cls, name: str, events: tuple[Event, ...]) -> ProbeView:
        probed = next((e for e in events if isinstance(e, Probed) and e.process == name), None)
        if probed is None:
            return cls(name, False, False, ())
        answers = tuple(ProbeAnswer(**json.loads(text)) for text in probed.answers)
        return cls(name, True, probed.finished, answers)

    def answer(self, question: str) -> ProbeAnswer | None:
        """Return the answer to this question; None if the probe never asked it."""
        return next((answer for answer in self.answers if answer.question == question), None)

    @property
    def broken(self) -> ProbeAnswer | None:
        """The exception that ended the probe, usually because the learner's module cannot be imported."""
        return self.answer("")

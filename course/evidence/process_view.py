"""One program of a recording: its output, its end, and what can be expected of it."""

from __future__ import annotations

import signal
from dataclasses import dataclass
from itertools import takewhile

from course.evidence.events import (
    Event,
    OutputCut,
    OutputLine,
    ProcessExited,
    ProcessStarted,
    SignalSent,
)

_MORE = 4
_UNREADABLE = ("SyntaxError:", "IndentationError:", "TabError:")
TRACEBACK = "Traceback (most recent call last)"


@dataclass(frozen=True)
class ProcessView:
    """A program that the scenario ran. `started` is None when it never did.

    dropped: bytes of output that were not kept because there were too many.
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
        """Its end, when no signal of ours had been sent before."""
        if self.exited and not any(sent.t <= self.exited.t for sent in self.signals):
            return self.exited
        return None

    @property
    def lifetime(self) -> float | None:
        """Seconds from its start to its end; None while there was no end."""
        if self.started and self.exited:
            return self.exited.t - self.started.t
        return None

    def traceback(self, after: float = 0.0) -> tuple[str, ...]:
        """The last Python traceback that it printed from time `after` on; empty if none."""
        lines = [line.text for line in self.lines if line.t >= after]
        starts = [index for index, text in enumerate(lines) if TRACEBACK in text]
        return _one_traceback(lines[starts[-1] :]) if starts else _unreadable_script(lines)


def _unreadable_script(lines: list[str]) -> tuple[str, ...]:
    """A script that Python cannot read is told of without the traceback's first line."""
    if not lines or not lines[-1].startswith(_UNREADABLE):
        return ()
    files = [index for index, text in enumerate(lines) if text.startswith('  File "')]
    return tuple(lines[files[-1] :]) if files else ()


def _one_traceback(lines: list[str]) -> tuple[str, ...]:
    """From its first line to the line with the exception, which is the first not indented.

    An exception's message may go on over indented lines; a few of them are kept.
    """
    for index, text in enumerate(lines[1:], start=1):
        if text and not text.startswith((" ", "\t")):
            more = takewhile(lambda line: line.startswith((" ", "\t")), lines[index + 1 : index + 1 + _MORE])
            return (*lines[: index + 1], *more)
    return tuple(lines)

"""Everything that can be observed in a scenario, each as one small event on one time line.

`t` is always seconds since the recording began, on our own monotonic clock. Nothing here is
taken from what a submission claims: times of messages are those of our own reception.
"""

from __future__ import annotations

from dataclasses import dataclass

from course.evidence.graph import Graph


@dataclass(frozen=True)
class Event:
    """Something that happened `t` seconds after the recording began."""

    t: float


@dataclass(frozen=True)
class ProcessStarted(Event):
    """The arena started a program; `process` is its name in the recording."""

    process: str
    command: tuple[str, ...]


@dataclass(frozen=True)
class ExecutableMissing(Event):
    """The arena was to start an executable that is not installed; `available` is what is."""

    process: str
    package: str
    executable: str
    available: tuple[str, ...]


@dataclass(frozen=True)
class OutputLine(Event):
    """One line on the program's terminal, without its line end and terminal colours."""

    process: str
    text: str


@dataclass(frozen=True)
class OutputCut(Event):
    """The program wrote more than is kept: `dropped` bytes of its output are not recorded."""

    process: str
    dropped: int


@dataclass(frozen=True)
class SignalSent(Event):
    """The arena sent `signal` (its number) to the program and its children."""

    process: str
    signal: int


@dataclass(frozen=True)
class ProcessExited(Event):
    """The program ended: with exit `code`, or killed by `signal`."""

    process: str
    code: int | None
    signal: int | None


@dataclass(frozen=True)
class MessageSeen(Event):
    """A message that our own subscription received; `data` is its CDR bytes."""

    topic: str
    type: str
    data: bytes


@dataclass(frozen=True)
class MessageSent(Event):
    """A message that the arena published as stimulus; `data` is its CDR bytes."""

    topic: str
    type: str
    data: bytes


@dataclass(frozen=True)
class MessagesLost(Event):
    """Our own reception missed `count` messages on `topic`: our fault, never the learner's."""

    topic: str
    count: int


@dataclass(frozen=True)
class GraphSeen(Event):
    """The ROS graph as it was from this moment on (our own nodes left out)."""

    graph: Graph


@dataclass(frozen=True)
class FileKept(Event):
    """A text file that the scenario found and kept; `text` is None when it was not there."""

    name: str
    text: str | None


@dataclass(frozen=True)
class MessagesCut(Event):
    """More messages came on `topic` than are kept; those after this moment are not recorded."""

    topic: str


@dataclass(frozen=True)
class Marked(Event):
    """The scenario reached a point worth naming, e.g. that it gave up waiting for something."""

    name: str
    detail: str = ""

"""Everything that can be observed in a scenario, each as one small event on one time line.

`t` is always seconds since the recording began, on our own monotonic clock. Nothing here is
taken from what a submission claims: times of messages are those of our own reception.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from course.evidence.graph import Graph, Kind

Side = Literal["client", "server"]


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
class LimitReached(Event):
    """The programs used up too much of something, and all of them were killed.

    limit: "memory", "processes", "cpu" or "disk". most: bytes, a number, or seconds.
    """

    limit: str
    most: float


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
class Joined(Event):
    """The arena itself took part in a topic from this moment on. end: what it made there."""

    topic: str
    type: str
    end: Kind


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
class ServiceCalled(Event):
    """A request to a service; `data` is its CDR bytes.

    side: what the arena was in this, "client" of the learner's server or "server" itself.
    type: the service's (`pkg/srv/Type`). call: tells this call from all others.
    client: which of the arena's clients asked; or the learner's node that did, "" when that is
    not certain.
    """

    service: str
    type: str
    side: Side
    call: str
    client: str
    data: bytes


@dataclass(frozen=True)
class ServiceAnswered(Event):
    """The answer to `call` came, or was given by the arena; `data` is its CDR bytes."""

    service: str
    type: str
    side: Side
    call: str
    data: bytes


@dataclass(frozen=True)
class ProcessLeft(Event):
    """The program `process` ended on Ctrl+C, and left one that it had started running: `command`."""

    process: str
    pid: int
    command: tuple[str, ...]


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


@dataclass(frozen=True)
class Watched(Event):
    """From this moment on (`on`), or up to it, it was noted how late the machine lets a program go on.

    waited: at the end, the seconds for which a program's thread was kept from running, the longest of all;
    0 where the kernel does not tell.
    """

    on: bool
    waited: float = 0.0


@dataclass(frozen=True)
class Late(Event):
    """A thread of ours got the CPU `seconds` later than it wanted: the machine has too much to do."""

    seconds: float


@dataclass(frozen=True)
class ProgramMissing(Event):
    """The arena was to start a file of the course home that is not there."""

    process: str
    file: str


@dataclass(frozen=True)
class ShellPrompt(Event):
    """A shell showed its prompt; `code` is the exit code of what ran before."""

    process: str
    code: int


@dataclass(frozen=True)
class ShellReady(Event):
    """An interactive bash had read its start files and showed its first prompt."""

    process: str
    printed: tuple[str, ...]


@dataclass(frozen=True)
class ShellRan(Event):
    """A command typed in a shell, from `began` (s) to `t`: what came on the terminal, its exit code.

    code: None when the shell did not come back to its prompt.
    """

    process: str
    command: str
    printed: tuple[str, ...]
    code: int | None
    began: float


@dataclass(frozen=True)
class ShellStuck(Event):
    """A shell gave no prompt in time, or no more.

    reason: "ended", "replaced" (bash became another program), "running" (a program runs in it),
    "waiting" (bash itself waits, for input mostly), "busy" (bash computes) or "flood" (it printed
    more than is kept). program: its name, for "replaced" and "running".
    """

    process: str
    reason: str
    program: str
    printed: tuple[str, ...]


@dataclass(frozen=True)
class Probed(Event):
    """What a probe of ours found out of the learner's code.

    answers: JSON objects, one a question, as `course.arena.probe_program` writes them.
    finished: False when it did not come to its end in time.
    """

    process: str
    answers: tuple[str, ...]
    finished: bool


@dataclass(frozen=True)
class Drawn(Event):
    """The exercise's mystery was drawn from `seed`."""

    seed: int


@dataclass(frozen=True)
class Acted(Event):
    """What a mystery's nodes saw the learner do, before the recording: see `course.evidence.acts`."""

    name: str
    detail: str

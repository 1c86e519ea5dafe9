"""Everything that can be observed in a scenario, each as one small event on one timeline.

`t` is always seconds since the recording began, on our own monotonic clock. Nothing here relies on a
submission's claims: message times are when we received them.
"""

from __future__ import annotations

from typing import Any, Literal, Union

from msgspec import Struct

from course.model.feedback import Location
from course.model.graph import Graph, Kind

Side = Literal["client", "server"]


class Event(Struct, frozen=True, tag_field="kind", tag=True, forbid_unknown_fields=True):
    """Something that happened `t` seconds after the recording began."""

    t: float


class ProcessStarted(Event, frozen=True):
    """The arena started a program; `process` is its name in the recording."""

    process: str
    command: tuple[str, ...]


class ExecutableMissing(Event, frozen=True):
    """The arena was asked to start an executable that is not installed. available: those that are."""

    process: str
    package: str
    executable: str
    available: tuple[str, ...]


class OutputLine(Event, frozen=True):
    """One line on the program's terminal, without its line end and color codes."""

    process: str
    text: str


class OutputCut(Event, frozen=True):
    """The program wrote more than is kept: `dropped` bytes of its output are not recorded."""

    process: str
    dropped: int


class LimitReached(Event, frozen=True):
    """The programs exceeded a limit, and all of them were killed.

    limit: "memory", "processes", "cpu" or "disk". most: the limit in bytes, a number, or seconds.
    """

    limit: str
    most: float


class SignalSent(Event, frozen=True):
    """The arena sent `signal` (its number) to the program and its children."""

    process: str
    signal: int


class ProcessExited(Event, frozen=True):
    """The program ended: with exit `code`, or killed by `signal`."""

    process: str
    code: int | None
    signal: int | None


class MessageSeen(Event, frozen=True):
    """A message that our own subscription received; `data` is its CDR bytes."""

    topic: str
    type: str
    data: bytes


class MessageSent(Event, frozen=True):
    """A message that the arena published as a stimulus; `data` is its CDR bytes."""

    topic: str
    type: str
    data: bytes


class Joined(Event, frozen=True):
    """The arena itself joined a topic at this moment. end: what it created there."""

    topic: str
    type: str
    end: Kind


class MessagesLost(Event, frozen=True):
    """Our own subscription missed `count` messages on `topic`: our fault, never the learner's."""

    topic: str
    count: int


class GraphSeen(Event, frozen=True):
    """The ROS graph from this moment on, without our own nodes."""

    graph: Graph


class ServiceCalled(Event, frozen=True):
    """A request to a service; `data` is its CDR bytes.

    side: the arena's part, "client" of the learner's server or "server" itself. type: of the service
    (`pkg/srv/Type`). call: identifies this call. client: which of the arena's clients asked, or the
    learner's node; "" if that is uncertain.
    """

    service: str
    type: str
    side: Side
    call: str
    client: str
    data: bytes


class ServiceAnswered(Event, frozen=True):
    """The answer to `call` arrived, or the arena sent it; `data` is its CDR bytes."""

    service: str
    type: str
    side: Side
    call: str
    data: bytes


class ProcessLeft(Event, frozen=True):
    """The program `process` ended on Ctrl+C, but a process that it had started, `command`, kept running."""

    process: str
    pid: int
    command: tuple[str, ...]


class FileKept(Event, frozen=True):
    """A text file that the scenario kept; `text` is None if it did not exist."""

    name: str
    text: str | None


class MessagesCut(Event, frozen=True):
    """More messages came on `topic` than we keep; those after this moment are not recorded."""

    topic: str


class Marked(Event, frozen=True):
    """The scenario reached a point worth naming, for example that it gave up waiting for something."""

    name: str
    detail: str = ""


class Watched(Event, frozen=True):
    """We measured how late the machine lets a program run, from this moment on (`on`) or until it.

    waited: at the end, the longest time (s) for which any thread of a program was kept from running; 0 if
    the kernel does not say.
    """

    on: bool
    waited: float = 0.0


class Late(Event, frozen=True):
    """A thread of ours got the CPU `seconds` later than it should: the machine is too busy."""

    seconds: float


class ProgramMissing(Event, frozen=True):
    """The arena was asked to start a file in the course home that does not exist."""

    process: str
    file: str


class ShellPrompt(Event, frozen=True):
    """A shell showed its prompt; `code` is the exit code of what ran before."""

    process: str
    code: int


class ShellReady(Event, frozen=True):
    """An interactive bash has read its startup files and shown its first prompt."""

    process: str
    printed: tuple[str, ...]


class ShellRan(Event, frozen=True):
    """A command typed in a shell, from `began` (s) to `t`, with its terminal output and exit code.

    code: None if the shell did not return to its prompt.
    """

    process: str
    command: str
    printed: tuple[str, ...]
    code: int | None
    began: float


class ShellStuck(Event, frozen=True):
    """A shell did not show its prompt, at the start or after a command.

    reason: "ended", "replaced" (bash became another program), "running" (a program is running in it),
    "waiting" (bash itself is waiting, usually for input). Or "busy" (bash is computing), or "flood" (it
    printed more than we keep). program: its name, for "replaced" and "running".
    """

    process: str
    reason: str
    program: str
    printed: tuple[str, ...]


class Probed(Event, frozen=True):
    """What one of our probes found out about the learner's code.

    answers: JSON objects, one per question, as `course.arena.probe_program` writes them. finished: False if
    it did not reach its end in time.
    """

    process: str
    answers: tuple[str, ...]
    finished: bool


class Drawn(Event, frozen=True):
    """The exercise's mystery was drawn from `seed`."""

    seed: int


class Acted(Event, frozen=True):
    """What a mystery's nodes saw the learner do, before the recording: see `course.evidence.acts`."""

    name: str
    detail: str


class Observed(Event, frozen=True):
    """What a second run noted inside a program: see `course.arena.observer_program`.

    The program may have forged it, so it is used for advice, never for a verdict. Files are named as the
    program knows them. `what` is one of these:

    - "caught": an `except` at `by` took `error`, raised at `raised`.
    - "died": `error` ended a thread or task.
    - "stood" or "looped": the main thread was in the function at `by` for `seconds`. `error` says whether ROS
      had called it.
    - "ran": `lines` of the file `by`.
    - "crashed": a sanitizer stopped C++ at or below `raised`. `error` is its name for the reason.
    """

    what: Literal["caught", "died", "stood", "looped", "ran", "crashed"]
    error: str = ""
    raised: Location | None = None
    by: Location | None = None
    seconds: float = 0.0
    lines: tuple[int, ...] = ()


# The type for reading events; each states its `kind`.
AnyEvent: Any = Union[tuple(Event.__subclasses__())]  # noqa: UP007 - made from a list

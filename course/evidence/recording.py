"""A finished recording and the questions that checks ask of it. Needs no ROS.

`Recording` holds everything that was observed on one time line. `topic()`, `process()`, `log` and `graphs`
give views of it.
"""

from __future__ import annotations

import signal
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from math import inf
from typing import TypeVar

from course.evidence.acts import Act, acts_of
from course.evidence.home_files import Home, HomeEntry
from course.evidence.messages import Decoder
from course.evidence.packages import BuiltPackages
from course.evidence.parameter_view import EVENTS, ParameterView
from course.evidence.process_view import LaunchView, ProbeView, ProcessView, ShellView
from course.evidence.service_view import ServiceView
from course.evidence.sources import Sources
from course.evidence.stream import Stream
from course.evidence.topic_view import LogLine, Message, TopicView
from course.model.events import (
    Drawn,
    Event,
    ExecutableMissing,
    FileKept,
    GraphSeen,
    Late,
    LimitReached,
    Marked,
    MessageSeen,
    MessageSent,
    MessagesLost,
    ProcessExited,
    ProgramMissing,
    SignalSent,
    Watched,
)
from course.model.graph import Endpoint, Graph

_E = TypeVar("_E", bound=Event)

ROSOUT = "/rosout"
ROSOUT_TYPE = "rcl_interfaces/msg/Log"
# Marks that a request or an answer was not valid UTF-8, so ROS could not read it.
UNREADABLE = "unreadable request or answer"
# How many messages a node with the usual queue of ten can send at once without losing any.
_QUEUE, _AT_ONCE = 10, 0.05
# Marks that the graph changed too often, and was too large, to keep every change.
GRAPH_CUT = "graph cut"


@dataclass(frozen=True)
class Recording:
    """Everything observed in one scenario.

    exercise: its id. events: sorted by time. definitions: type name to text definition, for every type
    among the messages. sources: the learner's files. packages: what was built. duration: seconds from the
    start of the recording to its end. looked_at: the files and folders of the course home that the exercise
    is about. local: False for a submission, which lacks anything tied to the learner's own machine.
    scenario: digest of the scenario that made it; empty if unknown.
    """

    exercise: str
    events: tuple[Event, ...] = ()
    definitions: Mapping[str, str] = field(default_factory=dict)
    sources: Sources = field(default_factory=Sources)
    packages: BuiltPackages = field(default_factory=BuiltPackages)
    duration: float = 0.0
    looked_at: tuple[HomeEntry, ...] = ()
    local: bool = True
    scenario: str = ""

    @cached_property
    def home(self) -> Home:
        """The files and folders of the course home that the exercise looks at."""
        return Home.of(self.looked_at, self.sources)

    @cached_property
    def decoder(self) -> Decoder:
        return Decoder(self.definitions)

    def topic(self, name: str) -> TopicView:
        """Return what was received on a topic, by its full name (`/chatter`)."""
        return TopicView(name, self.messages(name), self.lost(name), self.duration)

    def messages(self, topic: str) -> tuple[Message, ...]:
        """Return the messages received on `topic`, decoded, in the order in which they arrived."""
        if topic not in self._messages:
            found = (self._decoded(event) for event in self._of(MessageSeen) if event.topic == topic)
            self._messages[topic] = tuple(found)
        return self._messages[topic]

    def sent(self, topic: str) -> tuple[Message, ...]:
        """Return the messages that the arena itself published on `topic`."""
        return tuple(self._decoded(event) for event in self._of(MessageSent) if event.topic == topic)

    def reactions(self, topic: str) -> tuple[Reaction, ...]:
        """Return what followed each message that the arena published on `topic`, until its next one there.

        The scenario must wait for each reaction before it publishes again: see `arena.say`.
        """
        sent = self.sent(topic)
        ends = (*(message.t for message in sent[1:]), inf)
        return tuple(Reaction(self, message, end) for message, end in zip(sent, ends, strict=bool(sent)))

    def lost(self, topic: str) -> int:
        """Return how many messages on `topic` our own subscription missed.

        If a burst was larger than the sender's own queue, the loss may be the sender's.
        """
        missed = [event for event in self._of(MessagesLost) if event.topic == topic]
        times = [event.t for event in self._of(MessageSeen) if event.topic == topic] if missed else []
        return sum(event.count for event in missed if not _is_flood(event, times))

    def stream(self, topic: str, field: str) -> Stream:
        """Return the numbers in the list `field` of each message received on `topic`, with their times."""
        return Stream.of(topic, field, self.messages(topic), self.lost(topic))

    def sent_stream(self, topic: str, field: str) -> Stream:
        """Like `stream`, for the messages that the arena itself published on `topic`."""
        return Stream.of(topic, field, self.sent(topic))

    def is_overloaded(self, begin: float, end: float) -> bool:
        """Whether this machine held programs up between `begin` and `end` (s); needs `arena.lateness()`."""
        return is_overloaded(self.events, begin, end)

    def service(self, name: str) -> ServiceView:
        """Return a service's calls, by its full name: the arena's own, and those that reached its server."""
        return ServiceView.of(name, self.events, self.decoder)

    def parameters(self, node: str) -> ParameterView:
        """Return what the scenario learned about a node's parameters. node: its full name."""
        return ParameterView.of(node, lambda name: self.service(name).calls, self.messages(EVENTS))

    def process(self, name: str) -> ProcessView:
        """Return a program that the scenario ran, by the name the scenario gave it."""
        return ProcessView.of(name, self.events)

    def shell(self, name: str = "bash") -> ShellView:
        """Return an interactive bash that the scenario opened."""
        return ShellView.of(name, self.events)

    def probe(self, name: str = "probe") -> ProbeView:
        """Return what a probe found out about the learner's code."""
        return ProbeView.of(name, self.events)

    @property
    def limit_reached(self) -> LimitReached | None:
        """Set if the programs exceeded a limit and were all killed."""
        return next(iter(self._of(LimitReached)), None)

    @property
    def killed(self) -> ProcessExited | None:
        """The end of a program that was killed by itself or from outside: not by us, nor by a limit."""
        if self.limit_reached:
            return None
        ours = {sent.process for sent in self._of(SignalSent) if sent.signal == signal.SIGKILL}
        ends = (ended for ended in self._of(ProcessExited) if ended.signal == signal.SIGKILL)
        return next((ended for ended in ends if ended.process not in ours), None)

    def missing_program(self, process: str) -> ProgramMissing | None:
        """Return an event if the scenario found no file to start under that name."""
        return next((event for event in self._of(ProgramMissing) if event.process == process), None)

    def launched(self, name: str) -> LaunchView:
        """Return a launch file that the scenario ran, by the name the scenario gave it."""
        return LaunchView.of(name, self.events)

    def missing_executable(self, process: str) -> ExecutableMissing | None:
        """Return an event if the scenario found no executable to run under that name."""
        return next((event for event in self._of(ExecutableMissing) if event.process == process), None)

    @cached_property
    def log(self) -> tuple[LogLine, ...]:
        """Everything on /rosout."""
        return tuple(LogLine.of(message) for message in self.messages(ROSOUT))

    @cached_property
    def graphs(self) -> tuple[GraphSeen, ...]:
        """The ROS graph each time it changed."""
        return self._of(GraphSeen)

    def seen_nodes(self) -> tuple[str, ...]:
        """Return the full names of all nodes that ever appeared."""
        return tuple(sorted({name for seen in self.graphs for name in seen.graph.nodes}))

    def seen_endpoints(self) -> tuple[Endpoint, ...]:
        """Return all publishers and subscriptions that ever appeared, each once.

        An endpoint whose node was unknown at first is listed once, with the node's name.
        """
        every = {endpoint for seen in self.graphs for endpoint in seen.graph.endpoints}
        named = {endpoint for endpoint in every if endpoint.node}
        known = {(e.topic, e.kind, e.type) for e in named}
        unnamed = {e for e in every - named if (e.topic, e.kind, e.type) not in known}
        return tuple(sorted(named | unnamed))

    def seen_graph(self) -> Graph:
        """Return everything that ever appeared in the graph, as one graph."""
        services = {service for seen in self.graphs for service in seen.graph.services}
        return Graph(self.seen_nodes(), self.seen_endpoints(), tuple(sorted(services)))

    @property
    def seed(self) -> int | None:
        """The seed of the exercise's mystery; None without a mystery."""
        return next((event.seed for event in self._of(Drawn)), None)

    @property
    def acts(self) -> tuple[Act, ...]:
        """What the nodes of the exercise's mystery saw the learner do, each act once."""
        return acts_of(self.events)

    def kept(self, name: str) -> str | None:
        """Return the text of the file that the scenario kept under that name; None if it did not exist."""
        return next((event.text for event in self._of(FileKept) if event.name == name), None)

    def marked(self, name: str) -> Marked | None:
        """Return the moment that the scenario marked with that name; None if it never did."""
        return next((event for event in self._of(Marked) if event.name == name), None)

    @cached_property
    def _messages(self) -> dict[str, tuple[Message, ...]]:
        """Decoded messages by topic, because many checks ask for the same ones."""
        return {}

    def _decoded(self, event: MessageSeen | MessageSent) -> Message:
        return Message.of(event.t, event.topic, event.type, event.data, self.decoder)

    def _of(self, kind: type[_E]) -> tuple[_E, ...]:
        return tuple(event for event in self.events if isinstance(event, kind))


@dataclass(frozen=True)
class Reaction:
    """What was seen after one message of the arena, and before its next one at `until` (s).

    to: the message. until: infinite after the last one.
    """

    recording: Recording
    to: Message
    until: float

    @property
    def log(self) -> tuple[LogLine, ...]:
        """What was logged on /rosout."""
        return tuple(line for line in self.recording.log if self.to.t <= line.t < self.until)

    @property
    def logged(self) -> str:
        """The texts of these log lines, one per line."""
        return "\n".join(line.text for line in self.log)

    def topic(self, name: str) -> TopicView:
        """Return what arrived on a topic, by its full name."""
        return self.recording.topic(name).between(self.to.t, self.until)

    def printed(self, process: str) -> tuple[str, ...]:
        """Return what a program (by its name in the scenario) printed to its terminal."""
        lines = self.recording.process(process).lines
        return tuple(line.text for line in lines if self.to.t <= line.t < self.until)


def _is_flood(event: MessagesLost, times: Sequence[float]) -> bool:
    """Whether more messages than a queue holds came around the loss, counting the lost ones."""
    return event.count + sum(abs(t - event.t) <= _AT_ONCE for t in times) > _QUEUE


# A fraction of the time. A 2 ms loop that wakes as late as our samples (every 5 ms, see
# `arena.lateness_program`) then misses one round in twenty.
_MOST = 0.005
# A fraction of the watched time. A program whose thread had to wait that long may miss as many rounds.
_MOST_WAITED = 0.05


def is_overloaded(events: Iterable[Event], begin: float, end: float) -> bool:
    """Whether the machine was too busy from `begin` to `end` (s) to judge a pace by milliseconds.

    Programs that alternately sleep and wake, as drivers do, then got the CPU too late, through no fault of
    theirs. False if lateness was not measured.
    """
    events = tuple(events)
    late = sum(event.seconds for event in events if isinstance(event, Late) and begin <= event.t <= end)
    return late > _MOST * (end - begin) or _waited(events, begin, end) > _MOST_WAITED


def _waited(events: Iterable[Event], begin: float, end: float) -> float:
    """Among the watched times that overlap this one, the largest fraction for which a thread had to wait."""
    watched = [event for event in events if isinstance(event, Watched)]
    times = zip(watched[::2], watched[1::2], strict=False)  # start and end alternate
    within = ((on, off) for on, off in times if on.t <= end and off.t >= begin)
    return max((off.waited / (off.t - on.t) for on, off in within if on.t < off.t), default=0.0)

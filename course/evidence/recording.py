"""A finished recording and the questions that checks ask of it. Needs no ROS.

`Recording` holds everything that was observed on one time line. `topic()`, `process()`,
`node_log()` and `graph` give views of it; their `expect_*` methods raise a `Failure` whose
feedback says what was seen instead.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TypeVar

from course.evidence.acts import Act, acts_of
from course.evidence.events import (
    Drawn,
    Event,
    ExecutableMissing,
    FileKept,
    GraphSeen,
    LimitReached,
    Marked,
    MessageSeen,
    MessageSent,
    MessagesLost,
    ProgramMissing,
)
from course.evidence.graph import Endpoint, Graph
from course.evidence.home_files import Home, HomeEntry
from course.evidence.lateness import is_overloaded
from course.evidence.launch_view import LaunchView
from course.evidence.messages import Decoder
from course.evidence.packages import BuiltPackages
from course.evidence.parameter_view import ParameterView
from course.evidence.probe_view import ProbeView
from course.evidence.process_view import ProcessView
from course.evidence.service_view import ServiceView
from course.evidence.shell_view import ShellView
from course.evidence.sources import Sources
from course.evidence.stream import Stream
from course.evidence.topic_view import LogLine, Message, TopicView
from course.feedback import Pace

_E = TypeVar("_E", bound=Event)

ROSOUT = "/rosout"
ROSOUT_TYPE = "rcl_interfaces/msg/Log"
# The mark in a recording that a request or an answer was not valid UTF-8, so that ROS could not read it.
UNREADABLE = "unreadable request or answer"
# What a node with the usual queue of ten sends at once without losing some.
_QUEUE, _AT_ONCE = 10, 0.05
# The mark that the graph changed more often, and was larger, than is kept.
GRAPH_CUT = "graph cut"


@dataclass(frozen=True)
class Recording:
    """All that was observed in one scenario.

    exercise: its id. events: sorted by time. definitions: type name to text definition, for
    every type among the messages. sources: the learner's files. packages: what was built.
    duration: seconds from the start of the recording to its end. looked_at: the files and folders
    of the course home that the exercise is about. local: False for a submission, which comes without
    what belongs to the learner's own machine. scenario: digest of the scenario that made it; empty where
    that is not known.
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
        """What was received on a topic, by its full name (`/chatter`)."""
        return TopicView(name, self.messages(name), self.lost(name), self.duration, self.paces.append)

    def messages(self, topic: str) -> tuple[Message, ...]:
        """Messages received on `topic`, decoded, in the order of their arrival."""
        if topic not in self._messages:
            found = (self._decoded(event) for event in self._of(MessageSeen) if event.topic == topic)
            self._messages[topic] = tuple(found)
        return self._messages[topic]

    def sent(self, topic: str) -> tuple[Message, ...]:
        """Messages that the arena itself published on `topic`."""
        return tuple(self._decoded(event) for event in self._of(MessageSent) if event.topic == topic)

    def lost(self, topic: str) -> int:
        """How many messages our own reception missed on `topic`.

        Where more are sent at once than the sender's own queue holds, it was that one.
        """
        missed = [event for event in self._of(MessagesLost) if event.topic == topic]
        times = [event.t for event in self._of(MessageSeen) if event.topic == topic] if missed else []
        return sum(event.count for event in missed if not _is_flood(event, times))

    def stream(self, topic: str, field: str) -> Stream:
        """The numbers in the list `field` of each message received on `topic`, with their times."""
        return Stream.of(topic, field, self.messages(topic), self.lost(topic))

    def sent_stream(self, topic: str, field: str) -> Stream:
        """The same of what the arena itself published on `topic`."""
        return Stream.of(topic, field, self.sent(topic))

    def is_overloaded(self, begin: float, end: float) -> bool:
        """Whether this machine held programs up from `begin` to `end`, as `arena.lateness()` noted it."""
        return is_overloaded(self.events, begin, end)

    def service(self, name: str) -> ServiceView:
        """Calls of a service, by its full name: the arena's own, and those that reached its own server."""
        return ServiceView.of(name, self.events, self.decoder)

    def parameters(self, node: str) -> ParameterView:
        """What the scenario learned of a node's parameters. `node`: its full name."""
        return ParameterView.of(node, self)

    def process(self, name: str) -> ProcessView:
        """A program that the scenario ran, by the name it was given there."""
        return ProcessView.of(name, self.events)

    def shell(self, name: str = "bash") -> ShellView:
        """An interactive bash that the scenario opened."""
        return ShellView.of(name, self.events)

    def probe(self, name: str = "probe") -> ProbeView:
        """What a probe of the learner's code found out."""
        return ProbeView.of(name, self.events)

    @property
    def limit_reached(self) -> LimitReached | None:
        """Set when the programs used up too much of something, and were all killed."""
        return next(iter(self._of(LimitReached)), None)

    def missing_program(self, process: str) -> ProgramMissing | None:
        """Set when the scenario found no file to start under that name."""
        return next((event for event in self._of(ProgramMissing) if event.process == process), None)

    def launched(self, name: str) -> LaunchView:
        """A launch file that the scenario ran, by the name it was given there."""
        return LaunchView.of(name, self.events)

    def missing_executable(self, process: str) -> ExecutableMissing | None:
        """Set when the scenario found nothing to run under that name."""
        return next((event for event in self._of(ExecutableMissing) if event.process == process), None)

    def node_log(self, node: str) -> tuple[LogLine, ...]:
        """What the node wrote to /rosout. `node`: its name without a leading slash.

        ROS names the logger after the node, with dots for the slashes of its namespace.
        """
        logger = node.strip("/").replace("/", ".")
        return tuple(line for line in self.log if line.node == logger)

    @cached_property
    def log(self) -> tuple[LogLine, ...]:
        """Everything on /rosout."""
        return tuple(LogLine.of(message) for message in self.messages(ROSOUT))

    @cached_property
    def graphs(self) -> tuple[GraphSeen, ...]:
        """The ROS graph each time it changed."""
        return self._of(GraphSeen)

    def seen_nodes(self) -> tuple[str, ...]:
        """Full names of all nodes that were ever there."""
        return tuple(sorted({name for seen in self.graphs for name in seen.graph.nodes}))

    def seen_endpoints(self) -> tuple[Endpoint, ...]:
        """All publishers and subscriptions that were ever there, each once.

        An endpoint that was first seen without its node's name is given once, with the name.
        """
        every = {endpoint for seen in self.graphs for endpoint in seen.graph.endpoints}
        named = {endpoint for endpoint in every if endpoint.node}
        known = {(e.topic, e.kind, e.type) for e in named}
        unnamed = {e for e in every - named if (e.topic, e.kind, e.type) not in known}
        return tuple(sorted(named | unnamed))

    def seen_graph(self) -> Graph:
        """Everything that was ever in the graph, as one graph."""
        services = {service for seen in self.graphs for service in seen.graph.services}
        return Graph(self.seen_nodes(), self.seen_endpoints(), tuple(sorted(services)))

    @property
    def seed(self) -> int | None:
        """What the exercise's mystery was drawn from; None without one."""
        return next((event.seed for event in self._of(Drawn)), None)

    @property
    def acts(self) -> tuple[Act, ...]:
        """What the nodes of the exercise's mystery saw the learner do, each once."""
        return acts_of(self.events)

    def kept(self, name: str) -> str | None:
        """Text of the file that the scenario kept under that name; None if it was not there."""
        return next((event.text for event in self._of(FileKept) if event.name == name), None)

    def marked(self, name: str) -> Marked | None:
        """The point of that name that the scenario reached, if it did."""
        return next((event for event in self._of(Marked) if event.name == name), None)

    @cached_property
    def paces(self) -> list[Pace]:
        """What was asked of it up to now about how often messages come."""
        return []

    @cached_property
    def _messages(self) -> dict[str, tuple[Message, ...]]:
        """By topic, what was decoded already: many checks ask for the same."""
        return {}

    def _decoded(self, event: MessageSeen | MessageSent) -> Message:
        return Message.of(event.t, event.topic, event.type, event.data, self.decoder)

    def _of(self, kind: type[_E]) -> tuple[_E, ...]:
        return tuple(event for event in self.events if isinstance(event, kind))


def _is_flood(event: MessagesLost, times: Sequence[float]) -> bool:
    """Whether those that came around the loss, and those that did not, were more than a queue holds."""
    return event.count + sum(abs(t - event.t) <= _AT_ONCE for t in times) > _QUEUE

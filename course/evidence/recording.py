"""A finished recording and the questions that checks ask of it. Needs no ROS.

`Recording` holds everything that was observed on one time line. `topic()`, `process()`,
`node_log()` and `graph` give views of it; their `expect_*` methods raise a `Failure` whose
feedback says what was seen instead.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import TypeVar

from course.evidence.events import (
    Event,
    ExecutableMissing,
    FileKept,
    GraphSeen,
    Marked,
    MessageSeen,
    MessageSent,
    MessagesLost,
)
from course.evidence.graph import Endpoint, Graph
from course.evidence.messages import Decoder
from course.evidence.packages import BuiltPackages
from course.evidence.process_view import ProcessView
from course.evidence.sources import Sources
from course.evidence.topic_view import LogLine, Message, TopicView

_E = TypeVar("_E", bound=Event)

ROSOUT = "/rosout"
ROSOUT_TYPE = "rcl_interfaces/msg/Log"


@dataclass(frozen=True)
class Recording:
    """All that was observed in one scenario.

    exercise: its id. events: sorted by time. definitions: type name to text definition, for
    every type among the messages. sources: the learner's files. packages: what was built.
    duration: seconds from the start of the recording to its end.
    """

    exercise: str
    events: tuple[Event, ...] = ()
    definitions: Mapping[str, str] = field(default_factory=dict)
    sources: Sources = field(default_factory=Sources)
    packages: BuiltPackages = field(default_factory=BuiltPackages)
    duration: float = 0.0

    @cached_property
    def decoder(self) -> Decoder:
        return Decoder(self.definitions)

    def topic(self, name: str) -> TopicView:
        """What was received on a topic, by its full name (`/amazing_quote`)."""
        return TopicView(name, self.messages(name), self.lost(name), self.duration)

    def messages(self, topic: str) -> tuple[Message, ...]:
        """Messages received on `topic`, decoded, in the order of their arrival."""
        return tuple(self._decoded(event) for event in self._of(MessageSeen) if event.topic == topic)

    def sent(self, topic: str) -> tuple[Message, ...]:
        """Messages that the arena itself published on `topic`."""
        return tuple(self._decoded(event) for event in self._of(MessageSent) if event.topic == topic)

    def lost(self, topic: str) -> int:
        """How many messages our own reception missed on `topic`."""
        return sum(event.count for event in self._of(MessagesLost) if event.topic == topic)

    def process(self, name: str) -> ProcessView:
        """A program that the scenario ran, by the name it was given there."""
        return ProcessView.of(name, self.events)

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

    def kept(self, name: str) -> str | None:
        """Text of the file that the scenario kept under that name; None if it was not there."""
        return next((event.text for event in self._of(FileKept) if event.name == name), None)

    def marked(self, name: str) -> Marked | None:
        """The point of that name that the scenario reached, if it did."""
        return next((event for event in self._of(Marked) if event.name == name), None)

    def _decoded(self, event: MessageSeen | MessageSent) -> Message:
        return Message.of(event.t, event.type, event.data, self.decoder)

    def _of(self, kind: type[_E]) -> tuple[_E, ...]:
        return tuple(event for event in self.events if isinstance(event, kind))

"""The arena's own ROS node: `arena.ros`."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NoReturn

from course.errors import OurFault
from course.evidence.timeline import Timeline
from course.model.graph import Graph

if TYPE_CHECKING:
    from course.evidence.recorder import Listener, Recorder, Stimulus
    from course.evidence.ros_services import Answer, Client, Parameters, Server


class ArenaNode:
    """Topics, services, parameters and the graph, through the arena's own node, which records everything."""

    def __init__(self, recorder: Recorder) -> None:
        self._recorder = recorder

    @property
    def graph(self) -> Graph:
        """The ROS graph now, without the arena's own nodes."""
        return self._recorder.graph

    @property
    def definitions(self) -> dict[str, str]:
        """The text definitions of all message types in the recording."""
        return self._recorder.definitions

    def subscribe(self, topic: str, type_name: str, **qos: str) -> Listener:
        """Record every message on `topic` (full name) of type `pkg/msg/Type` from now on.

        qos: `reliability` and `durability`; the default matches any publisher.
        """
        return self._recorder.subscribe(topic, type_name, **qos)

    def publisher(self, topic: str, type_name: str, **qos: str) -> Stimulus:
        """Create a publisher of the arena; reliable and volatile by default."""
        return self._recorder.publisher(topic, type_name, **qos)

    def client(self, service: str, type_name: str) -> Client:
        """Create a client of the arena for a service (full name) of type `pkg/srv/Type`."""
        return self._recorder.client(service, type_name)

    def serve(self, service: str, type_name: str, answer: Answer) -> Server:
        """Offer a service; `answer` gets each request and returns response fields, or None to not answer."""
        return self._recorder.serve(service, type_name, answer)

    def parameters(self, node: str) -> Parameters:
        """Access the parameters of a node (full name) from outside. The node need not be running yet."""
        return self._recorder.parameters(node)


@dataclass(frozen=True)
class NoRos:
    """Replaces the recorder if an exercise does not use ROS, so that no middleware is started."""

    timeline: Timeline
    graph: Graph = field(default_factory=Graph)
    definitions: dict[str, str] = field(default_factory=dict)

    def __getattr__(self, name: str) -> NoReturn:
        if name.startswith("__"):
            raise AttributeError(name)
        raise OurFault(f"a scenario without ROS (`ros=False`) asks for `{name}`")

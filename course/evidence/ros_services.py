"""The arena's own service clients and servers; every call is on the time line.

Both live in the recorder's node and are served by its thread.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterator, Mapping
from math import inf
from typing import Any, Protocol

from course.errors import OurFault
from course.evidence.parameter_view import EVENTS, EVENTS_TYPE, ParameterData, to_fields
from course.evidence.timeline import Timeline
from course.model.events import ServiceAnswered, ServiceCalled
from course.model.graph import Graph

_PARTS = {"SendGoal": "SendGoalService", "GetResult": "GetResultService"}
Answer = Callable[[Any], Mapping[str, Any] | None]
# A client that never waits, or sends huge requests, must not fill our memory; no check needs more.
MAX_REQUESTS = 10_000
MAX_BYTES = 64 * 1024 * 1024


class RosSide(Protocol):
    """What clients and servers need from the recorder. numbers: one for each of them."""

    timeline: Timeline
    numbers: Iterator[int]
    graph: Graph

    @property
    def node(self) -> Any: ...
    @property
    def service_profile(self) -> Any: ...
    def define(self, type_name: str) -> None: ...
    def serialized(self, message: Any) -> bytes: ...
    def watch(self, state: Callable[[], object]) -> None: ...
    def subscribe(self, topic: str, type_name: str) -> object: ...


class Client:
    """Calls a service. Many calls may be in progress at once; an ordinary server queues only ten.

    type_name: `pkg/srv/Type`. name: what the recording calls it.
    """

    def __init__(self, recorder: RosSide, service: str, type_name: str) -> None:
        self._recorder = recorder
        self._number = next(recorder.numbers)
        self._class = _service_class(recorder, type_name)
        self._client = recorder.node.create_client(self._class, service, qos_profile=recorder.service_profile)
        self.service = service
        self.type = type_name
        self.name = f"client {self._number}"
        self.calls: list[Call] = []
        recorder.watch(lambda: self.available)

    @property
    def available(self) -> bool:
        """Whether there is a server of this name and type that would receive a call."""
        return bool(self._client.service_is_ready())

    @property
    def answered(self) -> int:
        """How many calls have been answered so far."""
        return sum(1 for call in self.calls if call.done)

    def call(self, **fields: Any) -> Call:
        """Send a request with these fields, without waiting; pass nested messages as dicts."""
        return self.send(filled(self._class.Request(), fields))

    def send(self, request: Any) -> Call:
        """Send a ready-made request."""
        call = Call(self, f"{self._number}.{len(self.calls)}")
        self.calls.append(call)
        timeline = self._recorder.timeline
        data = self._recorder.serialized(request)
        timeline.add(
            ServiceCalled(timeline.now(), self.service, self.type, "client", call.id, self.name, data)
        )
        self._client.call_async(request).add_done_callback(lambda future: self._answered(call, future))
        return call

    def _answered(self, call: Call, future: Any) -> None:
        call.response = future.result()
        timeline = self._recorder.timeline
        data = self._recorder.serialized(call.response)
        timeline.add(ServiceAnswered(timeline.now(), self.service, self.type, "client", call.id, data))


class Call:
    """One request of the arena. response: the ROS response; None until it arrives."""

    def __init__(self, client: Client, id: str) -> None:
        self.client = client
        self.id = id
        self.response: Any = None

    @property
    def done(self) -> bool:
        """Whether the response has arrived."""
        return self.response is not None


class Server:
    """Offers a service. `requests`: how many have come so far; those beyond the limit get no answer.

    answer: gets each request; returns the response's fields, or None for no answer at all. It runs in the
    recorder's thread, and must be quick.
    """

    def __init__(self, recorder: RosSide, service: str, type_name: str, answer: Answer) -> None:
        self._recorder = recorder
        self._number = next(recorder.numbers)
        self._class = _service_class(recorder, type_name)
        self._answer = answer
        self._answering = True
        self._resumed = -inf  # when it resumed, on the time line
        self.service = service
        self.type = type_name
        self.requests = 0
        self._bytes = 0
        self._open()
        recorder.watch(lambda: self.clients)

    def _open(self) -> None:
        # What rclpy's callback returns goes to `send_response` with the header that came with the
        # request; there it is known when the request arrived, and no answer need be sent.
        self._server = self._recorder.node.create_service(
            self._class,
            self.service,
            lambda request, response: request,
            qos_profile=self._recorder.service_profile,
        )
        self._send = self._server.send_response
        self._server.send_response = self._received

    @property
    def clients(self) -> int:
        """How many clients this service has now."""
        return int(self._recorder.node.count_clients(self.service))

    def pause(self) -> None:
        """From now on, receive requests without answering them."""
        self._answering = False

    def resume(self) -> None:
        """Answer again. Requests received during the pause stay unanswered, even those not yet processed."""
        self._resumed = self._recorder.timeline.now()
        self._answering = True

    def close(self) -> None:
        """Stop offering the service."""
        self._recorder.node.destroy_service(self._server)

    def _received(self, request: Any, header: Any) -> None:
        self.requests += 1
        if self.requests > MAX_REQUESTS or self._bytes > MAX_BYTES:
            return
        call = f"{self._number}.{self.requests}"
        timeline = self._recorder.timeline
        moment = timeline.when(int(header.received_timestamp))
        data, client = self._recorder.serialized(request), self._only_client()
        self._bytes += len(data)
        timeline.add(ServiceCalled(moment, self.service, self.type, "server", call, client, data))
        fields = self._answer(request) if self._answering and moment >= self._resumed else None
        if fields is None:
            return
        response = filled(self._class.Response(), fields)
        self._send(response, header)
        data = self._recorder.serialized(response)
        timeline.add(ServiceAnswered(timeline.now(), self.service, self.type, "server", call, data))

    def _only_client(self) -> str:
        """ROS does not say who asked; if only one node has a client, it was that one."""
        graph = self._recorder.graph
        nodes = {node for found in graph.services if found.name == self.service for node in found.clients}
        return nodes.pop() if len(nodes) == 1 else ""


def _service_class(recorder: RosSide, type_name: str) -> Any:
    recorder.define(f"{type_name}_Request")
    recorder.define(f"{type_name}_Response")
    return load_type(type_name)


def load_type(type_name: str) -> Any:
    """The Python class of a type's name, as for `full_definition`. Raises OurFault if this ROS lacks it."""
    package, kind, short = type_name.split("/")
    name, _, part = short.partition("_")
    try:
        found = getattr(importlib.import_module(f"{package}.{kind}"), name)
        return getattr(found.Impl, _PARTS.get(part, part)) if part else found
    except (ImportError, AttributeError) as error:
        raise OurFault(f"the grader cannot load the type {type_name}: {error}") from error


def filled(message: Any, fields: Mapping[str, Any]) -> Any:
    """`message` with these fields set; nested messages are given as dicts."""
    for name, value in fields.items():
        if isinstance(value, Mapping):
            filled(getattr(message, name), value)
        else:
            setattr(message, name, value)
    return message


_KINDS = {
    "get_parameters": "GetParameters",
    "list_parameters": "ListParameters",
    "describe_parameters": "DescribeParameters",
    "set_parameters": "SetParameters",
}


class Parameters:
    """The parameters of one node, accessed from outside. No method waits: see `Call.done`.

    If created before the node starts, it also receives the changes that the node announces. node: full
    name, such as `/talker`.
    """

    def __init__(self, recorder: RosSide, node: str) -> None:
        self.node = node
        recorder.subscribe(EVENTS, EVENTS_TYPE)
        self._clients = {
            name: Client(recorder, f"{node}/{name}", f"rcl_interfaces/srv/{kind}")
            for name, kind in _KINDS.items()
        }

    @property
    def available(self) -> bool:
        """Whether the node is there and would receive a call."""
        return all(client.available for client in self._clients.values())

    def get(self, *names: str) -> tuple[Call, ...]:
        """Ask for values, one call each, because ROS returns nothing at all if one of them is undeclared."""
        return tuple(self._clients["get_parameters"].call(names=[name]) for name in names)

    def list(self) -> Call:
        """Ask for the names of all parameters."""
        return self._clients["list_parameters"].call()

    def describe(self, *names: str) -> tuple[Call, ...]:
        """Ask for descriptors, one call each."""
        return tuple(self._clients["describe_parameters"].call(names=[name]) for name in names)

    def set(self, values: Mapping[str, ParameterData] | None = None, **more: ParameterData) -> Call:
        """Set parameters one by one, as `ros2 param set` does. A Python float becomes a double, and so on."""
        message = load_type("rcl_interfaces/msg/Parameter")
        parameters = [
            filled(message(), {"name": name, "value": to_fields(value)})
            for name, value in {**(values or {}), **more}.items()
        ]
        return self._clients["set_parameters"].call(parameters=parameters)

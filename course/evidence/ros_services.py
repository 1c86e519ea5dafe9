"""The arena's own clients and servers of services; every call is on the time line.

Both live in the recorder's node and are served by its thread.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import inf
from typing import TYPE_CHECKING, Any

from course.evidence.events import ServiceAnswered, ServiceCalled
from course.evidence.ros_types import filled, load_type

if TYPE_CHECKING:
    from course.evidence.recorder import Recorder

Answer = Callable[[Any], Mapping[str, Any] | None]
# A client that never waits, or asks at great length, must not fill our memory; nobody judges so many.
MAX_REQUESTS = 10_000
MAX_BYTES = 64 * 1024 * 1024


class Client:
    """Asks a service. Many calls may be under way at once; an ordinary server keeps ten waiting.

    type_name: `pkg/srv/Type`. name: what the recording calls this client.
    """

    def __init__(self, recorder: Recorder, service: str, type_name: str, name: str | None = None) -> None:
        self._recorder = recorder
        self._number = next(recorder.numbers)
        self._class = _service_class(recorder, type_name)
        self._client = recorder.node.create_client(self._class, service, qos_profile=recorder.service_profile)
        self.service = service
        self.type = type_name
        self.name = name or f"client {self._number}"
        self.calls: list[Call] = []
        recorder.watch(lambda: self.available)

    @property
    def available(self) -> bool:
        """Whether a server of this name and type is there, and would hear a call."""
        return bool(self._client.service_is_ready())

    @property
    def answered(self) -> int:
        """How many calls were answered up to now."""
        return sum(1 for call in self.calls if call.done)

    def call(self, **fields: Any) -> Call:
        """Send a request with these fields, and wait for nothing; nested messages are given as dicts."""
        return self.send(filled(self._class.Request(), fields))

    def send(self, request: Any) -> Call:
        """Send a request that is filled already."""
        call = Call(self, f"{self._number}.{len(self.calls)}")
        self.calls.append(call)
        timeline = self._recorder.timeline
        data = self._recorder.serialised(request)
        timeline.add(
            ServiceCalled(timeline.now(), self.service, self.type, "client", call.id, self.name, data)
        )
        self._client.call_async(request).add_done_callback(lambda future: self._answered(call, future))
        return call

    def _answered(self, call: Call, future: Any) -> None:
        call.response = future.result()
        timeline = self._recorder.timeline
        data = self._recorder.serialised(call.response)
        timeline.add(ServiceAnswered(timeline.now(), self.service, self.type, "client", call.id, data))


class Call:
    """One request of ours. response: the answer as ROS gives it, None until it came."""

    def __init__(self, client: Client, id: str) -> None:
        self.client = client
        self.id = id
        self.response: Any = None

    @property
    def done(self) -> bool:
        """Whether the answer came."""
        return self.response is not None


class Server:
    """Offers a service. `requests`: how many came up to now; beyond what is kept they get no answer.

    answer: gets each request; returns the response's fields, or None for no answer at all. It
    is called by the recorder's thread, and must be quick.
    """

    def __init__(self, recorder: Recorder, service: str, type_name: str, answer: Answer) -> None:
        self._recorder = recorder
        self._number = next(recorder.numbers)
        self._class = _service_class(recorder, type_name)
        self._answer = answer
        self._answering = True
        self._resumed = -inf  # when it began to answer again, on the time line
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
        """How many clients of this service there are now."""
        return int(self._recorder.node.count_clients(self.service))

    def pause(self) -> None:
        """From now on requests are heard, and never answered."""
        self._answering = False

    def resume(self) -> None:
        """Answer again; requests that came in between stay unanswered, also those not yet looked at."""
        self._resumed = self._recorder.timeline.now()
        self._answering = True

    def close(self) -> None:
        """Take the service away."""
        self._recorder.node.destroy_service(self._server)

    def _received(self, request: Any, header: Any) -> None:
        self.requests += 1
        if self.requests > MAX_REQUESTS or self._bytes > MAX_BYTES:
            return
        call = f"{self._number}.{self.requests}"
        timeline = self._recorder.timeline
        moment = timeline.when(int(header.received_timestamp))
        data, client = self._recorder.serialised(request), self._only_client()
        self._bytes += len(data)
        timeline.add(ServiceCalled(moment, self.service, self.type, "server", call, client, data))
        fields = self._answer(request) if self._answering and moment >= self._resumed else None
        if fields is None:
            return
        response = filled(self._class.Response(), fields)
        self._send(response, header)
        data = self._recorder.serialised(response)
        timeline.add(ServiceAnswered(timeline.now(), self.service, self.type, "server", call, data))

    def _only_client(self) -> str:
        """ROS does not say who asked; where one node only has a client, it was that."""
        graph = self._recorder.graph
        nodes = {node for found in graph.services if found.name == self.service for node in found.clients}
        return nodes.pop() if len(nodes) == 1 else ""


def _service_class(recorder: Recorder, type_name: str) -> Any:
    recorder.define(f"{type_name}_Request")
    recorder.define(f"{type_name}_Response")
    return load_type(type_name)

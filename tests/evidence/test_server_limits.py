"""Our server gets endless requests: beyond the limit, they are neither kept nor answered."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from course.evidence import ros_services as module
from course.evidence.ros_services import Server
from course.evidence.timeline import Timeline
from course.model.events import ServiceCalled
from course.model.graph import Graph


class Node:
    """Makes services that are never called by themselves."""

    def create_service(self, *given: Any, **named: Any) -> SimpleNamespace:
        return SimpleNamespace(send_response=lambda response, header: None)


class Recorder:
    numbers = iter(range(1, 9))
    service_profile = None
    node = Node()
    graph = Graph()

    def __init__(self) -> None:
        self.timeline = Timeline()

    def watch(self, state: object) -> None: ...

    def serialized(self, request: bytes) -> bytes:
        return request


@pytest.fixture
def recorder(monkeypatch: pytest.MonkeyPatch) -> Recorder:
    monkeypatch.setattr(module, "_service_class", lambda recorder, name: None)
    monkeypatch.setattr(module, "MAX_REQUESTS", 5)
    monkeypatch.setattr(module, "MAX_BYTES", 100)
    return Recorder()


def kept(recorder: Recorder, request: bytes) -> int:
    """Of eight such requests."""
    server = Server(recorder, "/ask", "std_srvs/srv/Trigger", lambda request: None)  # type: ignore[arg-type]
    for _ in range(8):
        server._received(request, SimpleNamespace(received_timestamp=0))
    assert server.requests == 8
    return len(list(recorder.timeline.of(ServiceCalled)))


def test_many(recorder: Recorder) -> None:
    assert kept(recorder, b"?") == 5


def test_large_ones(recorder: Recorder) -> None:
    assert kept(recorder, b"?" * 60) == 2

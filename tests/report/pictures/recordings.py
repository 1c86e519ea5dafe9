"""Recordings to draw."""

from __future__ import annotations

import struct

from course.evidence.recording import Recording
from course.model import events as kinds
from course.model.events import Event
from course.model.graph import Graph

NUMBER = "std_msgs/msg/Int32"
JOINTS = "sensor_msgs/msg/JointState"
DEFINITIONS = {NUMBER: "int32 data\n", JOINTS: "string[] name\nfloat64[] position\n"}
ADD = "example_interfaces/srv/AddTwoInts"


def number(t: float, value: int, topic: str = "/counted") -> kinds.MessageSeen:
    return kinds.MessageSeen(t, topic, NUMBER, b"\0\1\0\0" + struct.pack("<i", value))


def joints(t: float, **positions: float) -> kinds.MessageSeen:
    data = struct.pack("<I", len(positions))
    for name in positions:
        text = name.encode() + b"\0"
        data += struct.pack("<I", len(text)) + text + b"\0" * (-len(text) % 4)
    data += struct.pack("<I", len(positions))
    data += b"\0" * (-len(data) % 8) + struct.pack(f"<{len(positions)}d", *positions.values())
    return kinds.MessageSeen(t, "/joint_states", JOINTS, b"\0\1\0\0" + data)


def recording(*events: Event, duration: float = 6.0) -> Recording:
    return Recording("18-counter", tuple(sorted(events, key=lambda e: e.t)), DEFINITIONS, duration=duration)


COUNTER = (
    kinds.ProcessStarted(0.5, "counter", ("python3",)),
    kinds.OutputLine(0.8, "counter", "hello"),
    kinds.GraphSeen(0.9, Graph(("/counter",))),
    *(number(1 + place / 2, place * place) for place in range(6)),
    kinds.MessageSent(2.2, "/told", NUMBER, b"\0\1\0\0\1\0\0\0"),
    kinds.ServiceCalled(3.0, "/add", ADD, "client", "1", "", b""),
    kinds.ServiceAnswered(3.4, "/add", ADD, "client", "1", b""),
    kinds.SignalSent(5.0, "counter", 2),
    kinds.GraphSeen(5.2, Graph()),
    kinds.ProcessExited(5.5, "counter", 0, None),
)


def call(t: float, service: str, place: int) -> kinds.ServiceCalled:
    return kinds.ServiceCalled(t, f"/{service}", ADD, "client", f"{service}{place}", "", b"")


def flood(name: str) -> Recording:
    """As much of everything as can be drawn, with long and odd names."""
    events: list[Event] = []
    for place in range(12):
        own = f"{name}{place}"
        events += kinds.ProcessStarted(0.1, own, ()), kinds.GraphSeen(0.1 * place, Graph((f"/{own}",)))
        events += (kinds.OutputLine(0.013 * line, own, "x") for line in range(0, 400, 2))
        events += (number(0.011 * line, line % 7, f"/{own}") for line in range(500) if line % 3)
        events += (call(0.03 * n, own, n) for n in range(99))
        events += (kinds.SignalSent(0.02 * n, own, 2) for n in range(50))
    return recording(*events)

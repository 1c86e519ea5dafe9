"""Events as plain JSON and back, for everything that is not a ROS message."""

from __future__ import annotations

import base64
import dataclasses
from collections.abc import Mapping
from math import inf
from typing import Any

from course.evidence import events
from course.evidence.events import Event, GraphSeen
from course.evidence.graph import Endpoint, Graph, Qos, Service

_BYTES = "base64"
_KINDS: Mapping[str, type[Event]] = {
    kind.__name__: kind
    for kind in vars(events).values()
    if isinstance(kind, type) and issubclass(kind, Event) and kind is not Event
}


def to_dict(event: Event) -> dict[str, Any]:
    """The event's fields, and its class's name as `kind`.

    JSON knows no infinity: an endless deadline is null. It knows no bytes: they are base64.
    """
    return {"kind": type(event).__name__, **_plain(dataclasses.asdict(event))}


def from_dict(data: Mapping[str, Any]) -> Event:
    """Read what `to_dict` gave, after a way through JSON. Raises KeyError or TypeError on anything else."""
    fields = {name: _frozen(value) for name, value in data.items() if name != "kind"}
    kind = _KINDS[data["kind"]]
    if kind is GraphSeen:
        return GraphSeen(fields["t"], _graph(data["graph"]))
    return kind(**fields)


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {name: _plain(item) for name, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    if isinstance(value, bytes):
        return {_BYTES: base64.b64encode(value).decode("ascii")}
    return None if value == inf else value


def _frozen(value: Any) -> Any:
    """JSON has lists where events have tuples."""
    if isinstance(value, dict) and value.keys() == {_BYTES}:
        return base64.b64decode(value[_BYTES], validate=True)
    return tuple(_frozen(item) for item in value) if isinstance(value, list) else value


def _graph(data: Mapping[str, Any]) -> Graph:
    endpoints = (Endpoint(**{**item, "qos": _qos(item["qos"])}) for item in data["endpoints"])
    services = (Service(**{key: _frozen(value) for key, value in item.items()}) for item in data["services"])
    return Graph(tuple(data["nodes"]), tuple(endpoints), tuple(services))


def _qos(data: Mapping[str, Any]) -> Qos:
    return Qos(**{**data, "deadline": inf if data["deadline"] is None else data["deadline"]})

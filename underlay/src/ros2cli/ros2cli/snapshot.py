"""What is in the ROS graph at one moment, as plain data: taken once, asked by every listing verb."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

NO_NODE = "_NODE_NAME_UNKNOWN_"
_ROS_PREFIXES = {"rt": "topic", "rq": "request", "rr": "reply"}


@dataclass(frozen=True)
class Endpoint:
    """A writer or a reader of anyone's: `wire_name` and `wire_type` are as the middleware has them."""

    wire_name: str
    wire_type: str
    writes: bool
    node: str
    namespace: str
    gid: tuple[int, ...]
    type_hash: str = ""
    qos: Mapping[str, Any] = field(default_factory=dict, compare=False)

    @cached_property
    def kind(self) -> str:
        """topic, request, reply, or nothing for what is not of ROS."""
        return _ROS_PREFIXES.get(self.wire_name.partition("/")[0], "")

    @cached_property
    def name(self) -> str:
        """The name of the topic or service."""
        name = self.wire_name[2:]
        suffix = {"request": "Request", "reply": "Reply"}.get(self.kind, "")
        return name.removesuffix(suffix)

    @cached_property
    def type(self) -> str:
        """As ROS writes it: package/msg/Name."""
        package, _, name = self.wire_type.replace("::", "/").partition("/dds_/")
        if not name:
            return self.wire_type
        name = name.removesuffix("_")
        for suffix in ("_Request", "_Response") if self.kind in ("request", "reply") else ():
            name = name.removesuffix(suffix)
        return f"{package}/{name}"

    @property
    def full_node(self) -> str:
        return full_name(self.namespace, self.node)

    @property
    def process(self) -> tuple[int, ...]:
        """The part of the GID that all endpoints of one process share."""
        return self.gid[:12]

    @property
    def machine(self) -> tuple[int, ...]:
        """Fast DDS begins a GID with the vendor and a number made of the machine's addresses."""
        return self.gid[:4]


@dataclass(frozen=True)
class Snapshot:
    """`nodes` are full names, one for each node: a name that two nodes have is there twice."""

    nodes: tuple[str, ...]
    endpoints: tuple[Endpoint, ...]

    def topics(self, *, hidden: bool = False) -> dict[str, list[str]]:
        return self._types((end for end in self.endpoints if end.kind == "topic"), hidden)

    def services(self, *, hidden: bool = False) -> dict[str, list[str]]:
        """Of those that a server offers or a client waits for."""
        return self._types((end for end in self.endpoints if end.kind in ("request", "reply")), hidden)

    def publishers(self, topic: str) -> list[Endpoint]:
        return [end for end in self._of("topic", topic) if end.writes]

    def subscriptions(self, topic: str) -> list[Endpoint]:
        return [end for end in self._of("topic", topic) if not end.writes]

    def servers(self, service: str) -> list[Endpoint]:
        return [end for end in self._of("request", service) if not end.writes]

    def clients(self, service: str) -> list[Endpoint]:
        return [end for end in self._of("request", service) if end.writes]

    def of_node(self, node: str, kind: str, *, writes: bool) -> dict[str, list[str]]:
        """Name and types of a node's endpoints of this kind."""
        chosen = (e for e in self.endpoints if e.kind == kind and e.writes == writes and e.full_node == node)
        return self._types(chosen, hidden=True)

    def _of(self, kind: str, name: str) -> list[Endpoint]:
        return [end for end in self.endpoints if end.kind == kind and end.name == name]

    @staticmethod
    def _types(endpoints: Iterable[Endpoint], hidden: bool) -> dict[str, list[str]]:
        found: dict[str, set[str]] = {}
        for end in endpoints:
            if hidden or not is_hidden(end.name):
                found.setdefault(end.name, set()).add(end.type)
        return {name: sorted(types) for name, types in sorted(found.items())}


def is_hidden(name: str) -> bool:
    """Whether a part of the name begins with an underscore."""
    return any(part.startswith("_") for part in name.split("/"))


def full_name(namespace: str, name: str) -> str:
    return f"{namespace.rstrip('/')}/{name}"


def to_data(snapshot: Snapshot) -> dict[str, Any]:
    fields = Endpoint.__dataclass_fields__
    ends = [[getattr(end, name) for name in fields] for end in snapshot.endpoints]
    return {"nodes": snapshot.nodes, "endpoints": ends}


def from_data(data: Mapping[str, Any]) -> Snapshot:
    ends = (
        Endpoint(*[tuple(part) if isinstance(part, list) else part for part in end])
        for end in data["endpoints"]
    )
    return Snapshot(tuple(data["nodes"]), tuple(ends))

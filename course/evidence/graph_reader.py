"""Reads the ROS graph from a node of ours; cheap while nothing changes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from course.model.graph import Endpoint, Graph, Kind, Qos, Service

# The middleware gives "no deadline" as nearly 300 years.
_FOR_EVER = 1e9


class GraphReader:
    """Turns rclpy's graph queries into a `Graph` that leaves out the reading node.

    node: an rclpy node; typed loosely because only the recorder imports rclpy.
    """

    def __init__(self, node: Any) -> None:
        self._node = node
        self._own = str(node.get_fully_qualified_name())
        self._services = ServiceReader(node, self._own)
        self._signature: object = None

    def read_if_changed(self) -> Graph | None:
        """The graph, or None if a quick look shows no change."""
        signature = self._quick_look()
        if signature == self._signature:
            return None
        graph = self._read()
        # Node names arrive a little later than endpoints, and one of a server's two topics later
        # than the other; until then look again each time.
        named = all(endpoint.node for endpoint in graph.endpoints)
        self._signature = signature if named and self._services.complete else None
        return graph

    def _quick_look(self) -> object:
        node = self._node
        topics = node.get_topic_names_and_types()
        counts = [(node.count_publishers(name), node.count_subscribers(name)) for name, _ in topics]
        services = node.get_service_names_and_types()
        ends = [(node.count_services(name), node.count_clients(name)) for name, _ in services]
        return node.get_node_names_and_namespaces(), topics, counts, services, ends

    def _read(self) -> Graph:
        names = self._node.get_node_names_and_namespaces()
        nodes = sorted({full_name(name, namespace) for name, namespace in names} - {self._own})
        topics = [name for name, _ in self._node.get_topic_names_and_types()]
        endpoints = [endpoint for topic in topics for endpoint in self._endpoints(topic)]
        return Graph(tuple(nodes), tuple(sorted(endpoints)), self._services.read())

    def _endpoints(self, topic: str) -> Iterable[Endpoint]:
        for info in self._node.get_publishers_info_by_topic(topic):
            yield from self._endpoint(topic, "publisher", info)
        for info in self._node.get_subscriptions_info_by_topic(topic):
            yield from self._endpoint(topic, "subscription", info)

    def _endpoint(self, topic: str, kind: Kind, info: Any) -> Iterable[Endpoint]:
        node = node_of(info)
        if node == self._own:
            return
        yield Endpoint(topic, kind, node, info.topic_type, str(info.topic_type_hash), _qos(info.qos_profile))


def _qos(profile: Any) -> Qos:
    deadline = profile.deadline.nanoseconds / 1e9
    return Qos(
        profile.reliability.name.lower(),
        profile.durability.name.lower(),
        profile.liveliness.name.lower(),
        deadline if 0 < deadline < _FOR_EVER else 0.0,
    )


_UNKNOWN = "_NODE_NAME_UNKNOWN_"
_OWN_SERVICES = (
    "/describe_parameters",
    "/get_parameter_types",
    "/get_parameters",
    "/get_type_description",
    "/list_parameters",
    "/set_parameters",
    "/set_parameters_atomically",
)


@dataclass(frozen=True)
class _End:
    """One end of one of the two DDS topics that form a service."""

    node: str
    type: str | None
    type_hash: str


@dataclass(frozen=True)
class _Ends:
    """Servers subscribe to requests and publish replies; clients publish requests."""

    requests: tuple[_End, ...]
    replies: tuple[_End, ...]
    callers: tuple[_End, ...]

    @property
    def all(self) -> tuple[_End, ...]:
        return (*self.requests, *self.replies, *self.callers)

    def of(self, type_name: str) -> _Ends:
        return self._only(lambda end: end.type in (None, type_name))

    def without(self, node: str) -> _Ends:
        return self._only(lambda end: end.node != node)

    def _only(self, wanted: Any) -> _Ends:
        return _Ends(*(tuple(filter(wanted, ends)) for ends in (self.requests, self.replies, self.callers)))


class ServiceReader:
    """The services in the graph, without those of the reading node alone.

    node: an rclpy node. own: its full name. complete: whether the last reading left no gaps: node names
    arrive a little later than their ends, and one of a server's two ends later than the other.
    """

    def __init__(self, node: Any, own: str) -> None:
        self._node = node
        self._own = own
        self.complete = True

    def read(self) -> tuple[Service, ...]:
        """All services, sorted, except those that ROS creates in every node."""
        self.complete = True
        names = self._node.get_service_names_and_types()
        found = (
            service
            for name, types in names
            if not name.endswith(_OWN_SERVICES)
            for service in self._of_name(name, types)
        )
        return tuple(sorted(found))

    def _of_name(self, name: str, types: Sequence[str]) -> Iterable[Service]:
        every = self._ends(name)
        for type_name in types:
            ends = every.of(type_name)
            others = ends.without(self._own)
            if ends.all and not others.all:
                continue  # ours alone
            yield self._service(name, type_name, others)

    def _service(self, name: str, type_name: str, ends: _Ends) -> Service:
        half_known = bool(ends.requests) != bool(ends.replies)
        if half_known or not all(end.node for end in ends.all):
            self.complete = False
        known = ends.requests and ends.replies
        hashes = (ends.requests[0].type_hash, ends.replies[0].type_hash) if known else ("", "")
        return Service(name, type_name, *hashes, _nodes(ends.requests), _nodes(ends.callers))

    def _ends(self, name: str) -> _Ends:
        """The ends of the service's DDS topics, `rq/<service>Request` and `rr/<service>Reply`."""
        requests, replies = f"rq{name}Request", f"rr{name}Reply"
        return _Ends(
            _read(self._node.get_subscriptions_info_by_topic(requests, no_mangle=True)),
            _read(self._node.get_publishers_info_by_topic(replies, no_mangle=True)),
            _read(self._node.get_publishers_info_by_topic(requests, no_mangle=True)),
        )


def _read(infos: Iterable[Any]) -> tuple[_End, ...]:
    return tuple(
        _End(node_of(info), _service_type(info.topic_type), str(info.topic_type_hash)) for info in infos
    )


def _service_type(dds_type: str) -> str | None:
    """`pkg/srv/Type` from `pkg::srv::dds_::Type_Request_`; None for any other form."""
    parts = dds_type.split("::")
    if len(parts) != 4:
        return None
    return f"{parts[0]}/{parts[1]}/{parts[3].rstrip('_').rpartition('_')[0]}"


def _nodes(ends: Iterable[_End]) -> tuple[str, ...]:
    return tuple(sorted({end.node for end in ends if end.node}))


def node_of(info: Any) -> str:
    """Full name of the node that owns an end of a topic; "" while it is unknown."""
    if info.node_name == _UNKNOWN:
        return ""
    return full_name(info.node_name, info.node_namespace)


def full_name(name: str, namespace: str) -> str:
    """`/talker` or `/robot/talker`."""
    return f"{namespace.rstrip('/')}/{name}"

"""Reads the ROS graph from a node of ours; cheap while nothing changes."""

from __future__ import annotations

from collections.abc import Iterable
from math import inf
from typing import Any

from course.evidence.graph import Endpoint, Graph, Kind, Qos
from course.evidence.service_reader import ServiceReader, full_name, node_of

# The middleware gives "no deadline" as nearly 300 years.
_FOR_EVER = 1e9


class GraphReader:
    """Graph queries of rclpy, turned into a `Graph` without the reading node itself.

    node: an rclpy node; typed loosely because only the recorder knows rclpy.
    """

    def __init__(self, node: Any) -> None:
        self._node = node
        self._own = str(node.get_fully_qualified_name())
        self._services = ServiceReader(node, self._own)
        self._signature: object = None

    def read_if_changed(self) -> Graph | None:
        """The graph, or None when a quick look shows that nothing has changed."""
        signature = self._quick_look()
        if signature == self._signature:
            return None
        graph = self._read()
        # Node names reach us a little later than endpoints, and one of a server's two topics later
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
        deadline if 0 < deadline < _FOR_EVER else inf,
    )

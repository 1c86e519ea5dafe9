"""Reads the ROS graph from a node of ours; cheap while nothing changes."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from course.evidence.graph import Endpoint, Graph, Kind, Qos, Service

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


class GraphReader:
    """Graph queries of rclpy, turned into a `Graph` without the reading node itself.

    node: an rclpy node; typed loosely because only the recorder knows rclpy.
    """

    def __init__(self, node: Any) -> None:
        self._node = node
        self._own = str(node.get_fully_qualified_name())
        self._signature: object = None

    def read_if_changed(self) -> Graph | None:
        """The graph, or None when a quick look shows that nothing has changed."""
        signature = self._quick_look()
        if signature == self._signature:
            return None
        graph = self._read()
        complete = all(endpoint.node for endpoint in graph.endpoints)
        # Node names reach us a little later than endpoints; until then look again each time.
        self._signature = signature if complete else None
        return graph

    def _quick_look(self) -> object:
        node = self._node
        topics = node.get_topic_names_and_types()
        counts = [(node.count_publishers(name), node.count_subscribers(name)) for name, _ in topics]
        return node.get_node_names_and_namespaces(), topics, counts, node.get_service_names_and_types()

    def _read(self) -> Graph:
        names = self._node.get_node_names_and_namespaces()
        nodes = sorted({full_name(name, namespace) for name, namespace in names} - {self._own})
        topics = [name for name, _ in self._node.get_topic_names_and_types()]
        endpoints = [endpoint for topic in topics for endpoint in self._endpoints(topic)]
        return Graph(tuple(nodes), tuple(sorted(endpoints)), tuple(sorted(self._services())))

    def _endpoints(self, topic: str) -> Iterable[Endpoint]:
        for info in self._node.get_publishers_info_by_topic(topic):
            yield from self._endpoint(topic, "publisher", info)
        for info in self._node.get_subscriptions_info_by_topic(topic):
            yield from self._endpoint(topic, "subscription", info)

    def _endpoint(self, topic: str, kind: Kind, info: Any) -> Iterable[Endpoint]:
        known = info.node_name != _UNKNOWN
        node = full_name(info.node_name, info.node_namespace) if known else ""
        if node == self._own:
            return
        profile = info.qos_profile
        qos = Qos(profile.reliability.name.lower(), profile.durability.name.lower())
        yield Endpoint(topic, kind, node, info.topic_type, str(info.topic_type_hash), qos)

    def _services(self) -> Iterable[Service]:
        for name, types in self._node.get_service_names_and_types():
            if not name.endswith(_OWN_SERVICES):
                for type_name in types:
                    yield Service(name, type_name)


def full_name(name: str, namespace: str) -> str:
    """`/talker` or `/robot/talker`."""
    return f"{namespace.rstrip('/')}/{name}"

"""Takes a snapshot of the graph as rcl sees it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from ros2cli.rcl import Handle
from ros2cli.snapshot import Endpoint, Snapshot, full_name


def take_snapshot(handle: Handle) -> Snapshot:
    """Everything that the middleware has heard of by now."""
    nodes = sorted(
        full_name(namespace, name) for name, namespace, *_ in handle.node.get_node_names_and_namespaces()
    )
    ends = sorted(_endpoints(handle), key=lambda end: (end.wire_name, end.full_node, end.gid))
    return Snapshot(tuple(nodes), tuple(ends))


def _endpoints(handle: Handle) -> Iterator[Endpoint]:
    rcl, node = handle.rcl, handle.node
    for topic, _ in rcl.rclpy_get_topic_names_and_types(node, True):
        for info in rcl.rclpy_get_publishers_info_by_topic(node, topic, True):
            yield _endpoint(topic, info, writes=True)
        for info in rcl.rclpy_get_subscriptions_info_by_topic(node, topic, True):
            yield _endpoint(topic, info, writes=False)


def _endpoint(topic: str, info: Mapping[str, Any], *, writes: bool) -> Endpoint:
    return Endpoint(
        wire_name=topic,
        wire_type=info["topic_type"],
        writes=writes,
        node=info["node_name"],
        namespace=info["node_namespace"],
        gid=tuple(info["endpoint_gid"][:16]),
        type_hash=_type_hash(info.get("topic_type_hash")),
        qos=_qos(info["qos_profile"]),
    )


def _type_hash(value: Mapping[str, Any] | None) -> str:
    if not value or value["version"] < 1:
        return "INVALID"
    return f"RIHS{value['version']:02d}_{bytes(value['value']).hex()}"


def _qos(profile: Any) -> dict[str, Any]:
    """Numbers only; durations in nanoseconds."""
    values = dict(profile) if isinstance(profile, Mapping) else profile.to_dict()
    return {name: _number(value) for name, value in values.items()}


def _number(value: Any) -> Any:
    nanoseconds = getattr(value, "nanoseconds", None)
    return int(nanoseconds if nanoseconds is not None else value)

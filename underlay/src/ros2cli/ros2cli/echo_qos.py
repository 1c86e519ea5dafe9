"""The quality of service that hears every publisher of a topic."""

from __future__ import annotations

import sys
from argparse import Namespace
from typing import Any

from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

from ros2cli.discovery import discover
from ros2cli.node import handle_of
from ros2cli.qos_options import chosen_qos, is_chosen

# Deep enough for a burst while a terminal is slow.
DEPTH = 1000
_MIXED = (
    "Some, but not all, publishers are offering {strict}. "
    "Falling back to {loose} as it will connect to all publishers"
)


def qos_for(args: Namespace, node: Any, topic: str) -> Any:
    """What the options say; where they do not, as strict as all publishers are and no stricter."""
    qos = chosen_qos(args, "sensor_data", DEPTH)
    return qos if is_chosen(args) else fitting(node, topic, qos, args.spin_time)


def fitting(node: Any, topic: str, qos: QoSProfile, patience: float | None = None) -> QoSProfile:
    """The profile with the reliability and durability of all publishers that are there by now."""
    discover(handle_of(node), patience)
    offered = [info.qos_profile for info in node.get_publishers_info_by_topic(topic)]
    reliable = [offer.reliability == ReliabilityPolicy.RELIABLE for offer in offered]
    lasting = [offer.durability == DurabilityPolicy.TRANSIENT_LOCAL for offer in offered]
    qos.reliability = _common(reliable, ReliabilityPolicy.RELIABLE, ReliabilityPolicy.BEST_EFFORT)
    qos.durability = _common(lasting, DurabilityPolicy.TRANSIENT_LOCAL, DurabilityPolicy.VOLATILE)
    return qos


def _common(offers_strict: list[bool], strict: Any, loose: Any) -> Any:
    if offers_strict and all(offers_strict):
        return strict
    if any(offers_strict):
        names = {
            "strict": f"{type(strict).__name__}.{strict.name}",
            "loose": f"{type(loose).__name__}.{loose.name}",
        }
        print(_MIXED.format(**names), file=sys.stderr)
    return loose

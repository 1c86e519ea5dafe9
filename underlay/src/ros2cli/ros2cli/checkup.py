"""What `ros2 doctor` checks. Each check returns its warnings."""

from __future__ import annotations

import socket
from argparse import Namespace
from pathlib import Path

from ros2cli.graph import graph
from ros2cli.snapshot import Endpoint, Snapshot

_RELIABLE, _BEST_EFFORT = 1, 2
_TRANSIENT_LOCAL, _VOLATILE = 1, 2
_ALWAYS_THERE = ("/parameter_events", "/rosout")


def known_graph() -> Snapshot:
    return graph(Namespace(no_daemon=False, spin_time=None))


def network(known: Snapshot) -> list[str]:
    """Other machines are reached through something else than the loopback."""
    others = [name for _, name in socket.if_nameindex() if name != "lo" and _is_up(name)]
    return [] if others else ["Only loopback IP address is found."]


def of_users(known: Snapshot) -> list[str]:
    """The topics, without those that every node has."""
    return [name for name in known.topics() if name not in _ALWAYS_THERE]


def topics(known: Snapshot) -> list[str]:
    """Each publisher is heard, and each subscription has something to hear."""
    warnings = []
    for name in of_users(known):
        if not known.subscriptions(name):
            warnings.append(f"Publisher without subscriber detected on {name}.")
        elif not known.publishers(name):
            warnings.append(f"Subscriber without publisher detected on {name}.")
    return warnings


def qos(known: Snapshot) -> list[str]:
    """A publisher offers what each subscriber asks for."""
    pairs = (
        (pub, sub)
        for name in known.topics()
        for pub in known.publishers(name)
        for sub in known.subscriptions(name)
    )
    return [
        f"QoS of publisher {pub.full_node} and subscriber {sub.full_node} on {pub.name} do not fit: {fault}."
        for pub, sub in pairs
        if (fault := incompatibility(pub, sub))
    ]


def incompatibility(pub: Endpoint, sub: Endpoint) -> str:
    """Why nothing comes through, or nothing."""
    if pub.qos["reliability"] == _BEST_EFFORT and sub.qos["reliability"] == _RELIABLE:
        return "best effort publisher and reliable subscription"
    if pub.qos["durability"] == _VOLATILE and sub.qos["durability"] == _TRANSIENT_LOCAL:
        return "volatile publisher and transient local subscription"
    return ""


def _is_up(interface: str) -> bool:
    try:
        return Path("/sys/class/net", interface, "operstate").read_text(encoding="ascii").strip() != "down"
    except OSError:
        return False


CHECKS = {"network": network, "qos": qos, "topic": topics}

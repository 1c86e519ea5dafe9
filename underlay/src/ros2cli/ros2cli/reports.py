"""What `ros2 doctor --report` tells."""

from __future__ import annotations

import os
import platform
import socket
from collections.abc import Callable, Mapping, Sequence

from ros2cli.checkup import incompatibility, of_users
from ros2cli.interfaces import Row, interface_rows
from ros2cli.snapshot import Snapshot

# One list of rows for each section under the title.
Report = Callable[[Snapshot], tuple[str, list[list[Row]]]]
_NARROW, _GAP = 8, 4


def network(known: Snapshot) -> tuple[str, list[list[Row]]]:
    return "NETWORK CONFIGURATION", [interface_rows(name) for _, name in socket.if_nameindex()]


def packages(known: Snapshot) -> tuple[str, list[list[Row]]]:
    """Only what is installed: which versions are the latest is not to be known without the internet."""
    from ros2cli.verbs.pkg.installed import versions

    return "PACKAGE VERSIONS", [[(name, f"local={version}") for name, version in versions().items()]]


def machine(known: Snapshot) -> tuple[str, list[list[Row]]]:
    rows: list[Row] = [
        ("system", platform.system()),
        ("platform info", platform.platform()),
        ("release", platform.release()),
        ("processor", platform.processor()),
    ]
    return "PLATFORM INFORMATION", [rows]


def qos(known: Snapshot) -> tuple[str, list[list[Row]]]:
    sections: list[list[Row]] = [
        [
            ("topic [type]", f"{name} [{pub.type}]"),
            ("publisher node", pub.full_node),
            ("subscriber node", sub.full_node),
            ("compatibility status", incompatibility(pub, sub) or "OK"),
        ]
        for name in of_users(known)
        for pub in known.publishers(name)
        for sub in known.subscriptions(name)
    ]
    nothing: list[Row] = [("compatibility status", "No publisher/subscriber pairs found")]
    return "QOS COMPATIBILITY LIST", sections or [nothing]


def distribution(known: Snapshot) -> tuple[str, list[list[Row]]]:
    return "ROS 2 INFORMATION", [[("distribution name", os.environ.get("ROS_DISTRO", "unknown"))]]


def middleware(known: Snapshot) -> tuple[str, list[list[Row]]]:
    name = os.environ.get("RMW_IMPLEMENTATION") or "rmw_fastrtps_cpp"
    return "RMW MIDDLEWARE", [[("middleware name", name)]]


def topics(known: Snapshot) -> tuple[str, list[list[Row]]]:
    sections = [
        _topic(name, len(known.publishers(name)), len(known.subscriptions(name))) for name in of_users(known)
    ]
    return "TOPIC LIST", sections or [_topic("none", 0, 0)]


def _topic(name: str, publishers: int, subscribers: int) -> list[Row]:
    return [("topic", name), ("publisher count", publishers), ("subscriber count", subscribers)]


def print_reports(names: Sequence[str], known: Snapshot) -> None:
    for title, sections in (REPORTS[name](known) for name in names):
        rows = [row for section in sections for row in section]
        longest = max((len(name) for name, _ in rows), default=0)
        width = _NARROW if longest < _NARROW else longest + _GAP
        print(f"\n   {title}")
        for name, value in rows:
            print(f"{name.ljust(width)}: {value}")


REPORTS: Mapping[str, Report] = {
    "network": network,
    "package": packages,
    "platform": machine,
    "qos": qos,
    "rmw": middleware,
    "ros": distribution,
    "topic": topics,
}

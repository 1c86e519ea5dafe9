"""What `ros2 doctor --report` tells."""

from __future__ import annotations

import os
import platform
import socket
from collections.abc import Callable, Mapping

from ros2cli.checkup import incompatibility
from ros2cli.snapshot import Snapshot

Rows = list[tuple[str, object]]
Report = Callable[[Snapshot], tuple[str, Rows]]


def network(known: Snapshot) -> tuple[str, Rows]:
    return "NETWORK CONFIGURATION", [("device", name) for _, name in socket.if_nameindex()]


def machine(known: Snapshot) -> tuple[str, Rows]:
    rows: Rows = [("system", platform.system()), ("platform info", platform.platform())]
    return "PLATFORM INFORMATION", [
        *rows,
        ("release", platform.release()),
        ("processor", platform.processor()),
    ]


def qos(known: Snapshot) -> tuple[str, Rows]:
    rows: Rows = []
    for name in sorted(known.topics()):
        for pub in known.publishers(name):
            for sub in known.subscriptions(name):
                rows.append(("topic [type]", f"{name} [{pub.type}]"))
                rows.append(("publisher node", pub.full_node))
                rows.append(("subscriber node", sub.full_node))
                rows.append(("compatibility status", incompatibility(pub, sub) or "OK"))
    return "QOS COMPATIBILITY LIST", rows or [("compatibility status", "No publisher/subscriber pairs found")]


def middleware(known: Snapshot) -> tuple[str, Rows]:
    return "RMW MIDDLEWARE", [("middleware name", os.environ.get("RMW_IMPLEMENTATION") or "rmw_fastrtps_cpp")]


def topics(known: Snapshot) -> tuple[str, Rows]:
    rows: Rows = []
    for name in known.topics():
        rows.append(("topic", name))
        rows.append(("publisher count", len(known.publishers(name))))
        rows.append(("subscriber count", len(known.subscriptions(name))))
    return "TOPIC LIST", rows or [("topic", "none"), ("publisher count", 0), ("subscriber count", 0)]


def print_reports(reports: Mapping[str, Report], known: Snapshot) -> None:
    for report in reports.values():
        title, rows = report(known)
        width = max((len(name) for name, _ in rows), default=0)
        print(f"\n   {title}")
        for name, value in rows:
            print(f"{name.ljust(width)} : {value}")


REPORTS: dict[str, Report] = {
    "network": network,
    "platform": machine,
    "qos": qos,
    "rmw": middleware,
    "topic": topics,
}

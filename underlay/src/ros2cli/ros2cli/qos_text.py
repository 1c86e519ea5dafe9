"""A quality of service in words."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

_HISTORY = ("SYSTEM_DEFAULT", "KEEP_LAST", "KEEP_ALL", "UNKNOWN")
_RELIABILITY = ("SYSTEM_DEFAULT", "RELIABLE", "BEST_EFFORT", "UNKNOWN", "BEST_AVAILABLE")
_DURABILITY = ("SYSTEM_DEFAULT", "TRANSIENT_LOCAL", "VOLATILE", "UNKNOWN", "BEST_AVAILABLE")
_LIVELINESS = ("SYSTEM_DEFAULT", "AUTOMATIC", "UNKNOWN", "MANUAL_BY_TOPIC", "UNKNOWN", "BEST_AVAILABLE")
_INFINITE = 0x7FFFFFFFFFFFFFFF


def qos_lines(qos: Mapping[str, Any]) -> list[str]:
    """One line for each policy; the middleware does not tell history and depth of other processes."""
    history = _HISTORY[qos["history"]]
    depth = f" ({qos['depth']})" if history == "KEEP_LAST" else ""
    return [
        f"Reliability: {_RELIABILITY[qos['reliability']]}",
        f"History (Depth): {history}{depth}",
        f"Durability: {_DURABILITY[qos['durability']]}",
        f"Lifespan: {_duration(qos['lifespan'])}",
        f"Deadline: {_duration(qos['deadline'])}",
        f"Liveliness: {_LIVELINESS[qos['liveliness']]}",
        f"Liveliness lease duration: {_duration(qos['liveliness_lease_duration'])}",
    ]


def _duration(nanoseconds: int) -> str:
    return "Infinite" if nanoseconds >= _INFINITE else f"{nanoseconds} nanoseconds"

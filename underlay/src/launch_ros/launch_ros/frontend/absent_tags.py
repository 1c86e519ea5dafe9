"""Tags that the real package has and this one has not: refused when their turn comes."""

from __future__ import annotations

from typing import Any

from launch.absent import stand_in
from launch.frontend.entity import Entity

from launch_ros.actions import COMPONENTS, MANAGED, TIMER

_INSTEAD = {
    "composable_node": COMPONENTS,
    "lifecycle_node": MANAGED,
    "lifecycle_transition": MANAGED,
    "load_composable_node": COMPONENTS,
    "node_container": COMPONENTS,
    "ros_timer": TIMER,
}


def _refused(tag: str) -> Any:
    kind = stand_in("launch_ros.actions", tag, _INSTEAD[tag])
    kind.refusal = (f"<{tag}>", _INSTEAD[tag])  # type: ignore[attr-defined]

    def parse(entity: Entity, parser: Any) -> Any:
        entity.read_all()
        return kind, {}

    return parse


ABSENT_TAGS = {tag: _refused(tag) for tag in _INSTEAD}

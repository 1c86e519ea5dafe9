"""The topics of one robot: names below its prefix, hearing and telling."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from rclpy.node import Node
from sas_common import quiet_after_shutdown

JOINT_STATES = "get/joint_states"
JOINT_POSITIONS_MIN = "get/joint_positions_min"
JOINT_POSITIONS_MAX = "get/joint_positions_max"
HOME_STATES = "get/home_states"

TARGET_JOINT_POSITIONS = "set/target_joint_positions"
TARGET_JOINT_VELOCITIES = "set/target_joint_velocities"
TARGET_JOINT_FORCES = "set/target_joint_forces"
HOMING_SIGNAL = "set/homing_signal"
CLEAR_POSITIONS = "set/clear_positions"

# How many messages wait. Of what is heard only the latest counts: a loop wants to know what is true now.
_HEARD = 1
_TOLD = 10


@dataclass(frozen=True)
class Topics:
    """All that begin with `prefix`, on a node."""

    node: Node
    prefix: str

    @staticmethod
    def of(node: Node, prefix: str) -> Topics:
        return Topics(node, node.get_name() if prefix == "GET_FROM_NODE" else prefix)

    def hear(self, message_type: type, name: str, then: Callable[[], None] = lambda: None) -> Heard:
        """`then` is called for every message, when it can be read."""
        return Heard(self, message_type, name, then)

    def tell(self, message_type: type, name: str) -> Told:
        return Told(self, message_type, name)


class Heard:
    """What came last on a topic."""

    def __init__(self, topics: Topics, message_type: type, name: str, then: Callable[[], None]) -> None:
        self.message: Any = None
        self._topic, self._then = f"{topics.prefix}/{name}", then
        topics.node.create_subscription(message_type, self._topic, self._take, _HEARD)

    def get(self, field: str) -> Any:
        """A field of the message. Raise RuntimeError when none has come, or it is empty there."""
        value = getattr(self.message, field, None)
        if not value:
            raise RuntimeError(
                f"sas_robot_driver: nothing has come on {self._topic} yet that tells its {field}. "
                "Spin the node until is_enabled() is true."
            )
        return value

    def has(self, field: str) -> bool:
        return bool(getattr(self.message, field, None))

    def _take(self, message: Any) -> None:
        self.message = message
        self._then()


class Told:
    """Says things on a topic."""

    def __init__(self, topics: Topics, message_type: type, name: str) -> None:
        self._node = topics.node
        self._publisher = topics.node.create_publisher(message_type, f"{topics.prefix}/{name}", _TOLD)

    def __call__(self, message: Any) -> None:
        with quiet_after_shutdown(self._node):
            self._publisher.publish(message)

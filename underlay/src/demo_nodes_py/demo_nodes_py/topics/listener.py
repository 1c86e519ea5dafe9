"""Prints what the talker says."""

from __future__ import annotations

from collections.abc import Sequence

import rclpy
from rclpy.node import Node
from std_msgs.msg import String

from demo_nodes_py.running import running


class Listener(Node):
    """Subscribes to the topic `chatter`."""

    def __init__(self) -> None:
        super().__init__("listener")
        self._subscription = self.create_subscription(String, "chatter", self._hear, 10)

    def _hear(self, message: String) -> None:
        self.get_logger().info(f"I heard: [{message.data}]")


def main(args: Sequence[str] | None = None) -> None:
    """Run the node until it is interrupted."""
    with running(Listener, args) as node:
        rclpy.spin(node)


if __name__ == "__main__":
    main()

"""Says hello to the world once a second."""

from __future__ import annotations

from collections.abc import Sequence

import rclpy
from rclpy.node import Node
from std_msgs.msg import String

from demo_nodes_py.running import running


class Talker(Node):
    """Publishes a text with a count on the topic `chatter`."""

    def __init__(self) -> None:
        super().__init__("talker")
        self._count = 0
        self._publisher = self.create_publisher(String, "chatter", 10)
        self._timer = self.create_timer(1.0, self._publish)

    def _publish(self) -> None:
        message = String(data=f"Hello World: {self._count}")
        self._count += 1
        self.get_logger().info(f'Publishing: "{message.data}"')
        self._publisher.publish(message)


def main(args: Sequence[str] | None = None) -> None:
    """Run the node until it is interrupted."""
    with running(Talker, args) as node:
        rclpy.spin(node)


if __name__ == "__main__":
    main()

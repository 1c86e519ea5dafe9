"""Has one turtle do what another does."""

from __future__ import annotations

from collections.abc import Sequence

import rclpy
from demo_nodes_py.running import running
from geometry_msgs.msg import Twist
from rclpy.node import Node
from turtlesim.msg import Pose

from turtlesim_programs.turtle import TOPIC_QOS


class Mimic(Node):
    """Publishes the velocity in each pose of `input` as a command for `output`."""

    def __init__(self) -> None:
        super().__init__("turtle_mimic")
        self._commands = self.create_publisher(Twist, "output/cmd_vel", TOPIC_QOS)
        self._poses = self.create_subscription(Pose, "input/pose", self._on_pose, TOPIC_QOS)

    def _on_pose(self, pose: Pose) -> None:
        command = Twist()
        command.linear.x = pose.linear_velocity
        command.angular.z = pose.angular_velocity
        self._commands.publish(command)


def main(args: Sequence[str] | None = None) -> None:
    """Run the node until it is interrupted."""
    with running(Mimic, args) as node:
        rclpy.spin(node)


if __name__ == "__main__":
    main()

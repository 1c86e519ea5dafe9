"""Has turtle1 drive along a square, again and again."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import rclpy
from demo_nodes_py.running import running
from geometry_msgs.msg import Twist
from rclpy.node import Node
from std_srvs.srv import Empty
from turtlesim.msg import Pose

from turtlesim_programs.turtle import TOPIC_QOS, normalized

_SIDE = 2.0
_SPEED = 1.0
_TURN_RATE = 0.4
_STILL = 0.0001


class DrawSquare(Node):
    """In turns: drive to a corner, stop, turn left, stop."""

    def __init__(self) -> None:
        super().__init__("draw_square")
        self._commands = self.create_publisher(Twist, "turtle1/cmd_vel", TOPIC_QOS)
        self._subscription = self.create_subscription(Pose, "turtle1/pose", self._on_pose, TOPIC_QOS)
        self._pose: Pose | None = None
        self._goal = 0.0, 0.0, 0.0
        self._step: Callable[[Pose], None] | None = None
        self._reset = self.create_client(Empty, "reset")
        self._reset.call_async(Empty.Request())
        self._timer = self.create_timer(0.016, self._go_on)

    def _on_pose(self, pose: Pose) -> None:
        self._pose = pose

    def _go_on(self) -> None:
        if not (pose := self._pose):
            return
        if self._step is None:
            self._drive_from(pose)
        assert self._step
        self._step(pose)

    def _drive_from(self, pose: Pose) -> None:
        ahead = _SIDE * math.cos(pose.theta), _SIDE * math.sin(pose.theta)
        self._set_goal(pose.x + ahead[0], pose.y + ahead[1], pose.theta)
        self._step = self._drive

    def _turn_from(self, pose: Pose) -> None:
        self._set_goal(pose.x, pose.y, normalized(pose.theta + math.pi / 2))
        self._step = self._turn

    def _set_goal(self, x: float, y: float, theta: float) -> None:
        self._goal = x, y, theta
        self.get_logger().info(f"New goal [{x:f} {y:f}, {theta:f}]")

    def _drive(self, pose: Pose) -> None:
        self._command(linear=_SPEED)
        if self._is_there(pose):
            self._step = self._stop_before(self._turn_from)

    def _turn(self, pose: Pose) -> None:
        self._command(angular=_TURN_RATE)
        if self._is_there(pose):
            self._step = self._stop_before(self._drive_from)

    def _stop_before(self, following: Callable[[Pose], None]) -> Callable[[Pose], None]:
        def stop(pose: Pose) -> None:
            if abs(pose.linear_velocity) < _STILL and abs(pose.angular_velocity) < _STILL:
                self.get_logger().info("Reached goal")
                following(pose)
            else:
                self._command()

        return stop

    def _is_there(self, pose: Pose) -> bool:
        x, y, theta = self._goal
        near = abs(pose.x - x) < 0.1 and abs(pose.y - y) < 0.1
        return near and abs(normalized(pose.theta - theta)) < 0.01

    def _command(self, linear: float = 0.0, angular: float = 0.0) -> None:
        command = Twist()
        command.linear.x, command.angular.z = linear, angular
        self._commands.publish(command)


def main(args: Sequence[str] | None = None) -> None:
    """Run the node until it is interrupted."""
    with running(DrawSquare, args) as node:
        rclpy.spin(node)


if __name__ == "__main__":
    main()

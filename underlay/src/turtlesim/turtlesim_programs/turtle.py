"""One turtle: how it moves, and its topics, services and action."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from geometry_msgs.msg import Twist
from rclpy.action import ActionServer, CancelResponse
from rclpy.action.server import ServerGoalHandle
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.qos import QoSProfile
from rclpy.task import Future
from turtlesim.action import RotateAbsolute
from turtlesim.msg import Color as ColorMessage
from turtlesim.msg import Pose
from turtlesim.srv import SetPen, TeleportAbsolute, TeleportRelative

from turtlesim_programs.canvas import SIZE, Canvas, Color

TOPIC_QOS = QoSProfile(depth=7)
_COMMANDS_LAST = Duration(seconds=1)
_TURN_RATE = 1.0
_CLOSE_ENOUGH = 0.02


def normalized(angle: float) -> float:
    """The same angle between -pi and +pi."""
    return angle - 2 * math.pi * math.floor((angle + math.pi) / (2 * math.pi))


@dataclass
class _Rotation:
    goal: ServerGoalHandle
    start: float
    ended: Future
    result: RotateAbsolute.Result


class Turtle:
    """Moves and draws at each `update`."""

    def __init__(self, node: Node, name: str, canvas: Canvas, pose: tuple[float, float, float]) -> None:
        self._node = node
        self._canvas = canvas
        self.x, self.y, self.theta = pose
        self._forward = self._sideways = self._turning = 0.0
        self._pen: Color = (0xB3, 0xB8, 0xFF)
        self._pen_width = 3
        self._pen_is_down = True
        self._rotation: _Rotation | None = None
        self._commanded = node.get_clock().now()
        self._commands = node.create_subscription(Twist, f"{name}/cmd_vel", self._on_command, TOPIC_QOS)
        self._poses = node.create_publisher(Pose, f"{name}/pose", TOPIC_QOS)
        self._colors = node.create_publisher(ColorMessage, f"{name}/color_sensor", TOPIC_QOS)
        self._services = [
            node.create_service(SetPen, f"{name}/set_pen", self._set_pen),
            node.create_service(TeleportRelative, f"{name}/teleport_relative", self._teleport_relative),
            node.create_service(TeleportAbsolute, f"{name}/teleport_absolute", self._teleport_absolute),
        ]
        self._rotating = ActionServer(
            node,
            RotateAbsolute,
            f"{name}/rotate_absolute",
            self._rotate,
            cancel_callback=lambda goal: CancelResponse.ACCEPT,
        )

    def destroy(self) -> None:
        """Take its topics, services and action away."""
        self._end_rotation("abort")
        self._rotating.destroy()
        for service in self._services:
            self._node.destroy_service(service)
        self._node.destroy_subscription(self._commands)
        self._node.destroy_publisher(self._poses)
        self._node.destroy_publisher(self._colors)

    def update(self, seconds: float) -> None:
        """Move for `seconds`, draw, and publish."""
        self._turn_to_goal()
        if self._node.get_clock().now() - self._commanded > _COMMANDS_LAST:
            self._stop()
        before = self.x, self.y
        self.theta = normalized(self.theta + self._turning * seconds)
        ahead, aside = self._forward * seconds, self._sideways * seconds
        self.x += math.cos(self.theta) * ahead - math.sin(self.theta) * aside
        self.y += math.sin(self.theta) * ahead + math.cos(self.theta) * aside
        self._stay_inside()
        self._draw_from(before)
        speed = math.hypot(self._forward, self._sideways)
        pose = Pose(x=self.x, y=self.y, theta=self.theta, linear_velocity=speed)
        pose.angular_velocity = self._turning
        self._poses.publish(pose)
        red, green, blue = self._canvas.color_at(self.x, self.y)
        self._colors.publish(ColorMessage(r=red, g=green, b=blue))

    def _stay_inside(self) -> None:
        if not (0 <= self.x <= SIZE and 0 <= self.y <= SIZE):
            # The real one counts y downward here, and only here.
            where = f"[x={self.x:f}, y={SIZE - self.y:f}]"
            self._node.get_logger().warning(f"Oh no! I hit the wall! (Clamping from {where})")
        self.x, self.y = min(max(self.x, 0.0), SIZE), min(max(self.y, 0.0), SIZE)

    def _draw_from(self, before: tuple[float, float]) -> None:
        if self._pen_is_down and before != (self.x, self.y):
            self._canvas.line(before, (self.x, self.y), self._pen, self._pen_width)

    def _stop(self) -> None:
        self._forward = self._sideways = self._turning = 0.0

    def _on_command(self, command: Twist) -> None:
        self._commanded = self._node.get_clock().now()
        self._forward = command.linear.x
        self._sideways = command.linear.y if self._node.get_parameter("holonomic").value else 0.0
        self._turning = command.angular.z
        if self._rotation:
            self._node.get_logger().warning("Velocity command received during rotation goal. Aborting goal")
            self._end_rotation("abort")

    def _set_pen(self, request: SetPen.Request, response: SetPen.Response) -> SetPen.Response:
        self._pen_is_down = not request.off
        if self._pen_is_down:
            self._pen = request.r, request.g, request.b
            self._pen_width = request.width or 1
        return response

    def _teleport_relative(self, request: TeleportRelative.Request, response: Any) -> Any:
        before = self.x, self.y
        self.theta = normalized(self.theta + request.angular)
        self.x += math.cos(self.theta) * request.linear
        self.y += math.sin(self.theta) * request.linear
        self._draw_from(before)
        return response

    def _teleport_absolute(self, request: TeleportAbsolute.Request, response: Any) -> Any:
        before = self.x, self.y
        self.x, self.y, self.theta = request.x, request.y, normalized(request.theta)
        self._draw_from(before)
        return response

    async def _rotate(self, goal: ServerGoalHandle) -> RotateAbsolute.Result:
        if self._rotation:
            self._node.get_logger().warning(
                "Rotation goal received before a previous goal finished. Aborting previous goal"
            )
            self._end_rotation("abort")
        result = RotateAbsolute.Result()
        self._rotation = _Rotation(goal, self.theta, Future(), result)
        await self._rotation.ended
        return result

    def _turn_to_goal(self) -> None:
        if not (rotation := self._rotation):
            return
        remaining = normalized(rotation.goal.request.theta - self.theta)
        rotation.result.delta = normalized(rotation.start - self.theta)
        if rotation.goal.is_cancel_requested:
            self._node.get_logger().info("Rotation goal canceled")
            self._end_rotation("canceled")
            self._stop()
            return
        rotation.goal.publish_feedback(RotateAbsolute.Feedback(remaining=remaining))
        self._stop()
        if abs(remaining) < _CLOSE_ENOUGH:
            self._node.get_logger().info("Rotation goal completed successfully")
            self._end_rotation("succeed")
        else:
            self._turning = math.copysign(_TURN_RATE, remaining)
            self._commanded = self._node.get_clock().now()

    def _end_rotation(self, how: str) -> None:
        """`how` is the method of the goal's handle: abort, canceled or succeed."""
        if rotation := self._rotation:
            self._rotation = None
            getattr(rotation.goal, how)()
            rotation.ended.set_result(None)

"""Drives turtle1 with the keyboard."""

from __future__ import annotations

import math
import os
import select
import sys
import termios
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

import rclpy
from demo_nodes_py.running import running
from geometry_msgs.msg import Twist
from rclpy.action import ActionClient
from rclpy.action.client import ClientGoalHandle
from rclpy.node import Node
from rclpy.task import Future
from turtlesim.action import RotateAbsolute

from turtlesim_programs.turtle import TOPIC_QOS

_HELP = """\
Reading from keyboard
---------------------------
Use arrow keys to move the turtle.
Use G|B|V|C|D|E|R|T keys to rotate to absolute orientations. 'F' to cancel a rotation.
'Q' to quit.
"""
_ARROWS = {b"\x1b[A": (1, 0), b"\x1b[B": (-1, 0), b"\x1b[C": (0, -1), b"\x1b[D": (0, 1)}
# The keys around F, as they are around it on the keyboard: G is right of it, R and T are above.
_EIGHTHS = {b"g": 0, b"t": 1, b"r": 2, b"e": 3, b"d": 4, b"c": -3, b"v": -2, b"b": -1}


class Teleop(Node):
    """Publishes a velocity for each arrow key, and has turtle1 turn to a direction for others."""

    def __init__(self) -> None:
        super().__init__("teleop_turtle")
        self.declare_parameter("scale_angular", 2.0)
        self.declare_parameter("scale_linear", 2.0)
        self._commands = self.create_publisher(Twist, "turtle1/cmd_vel", TOPIC_QOS)
        self._rotating = ActionClient(self, RotateAbsolute, "turtle1/rotate_absolute")
        self._goal: ClientGoalHandle | None = None

    def press(self, key: bytes) -> None:
        """Do what `key` stands for, if anything."""
        if key in _ARROWS:
            linear, angular = _ARROWS[key]
            command = Twist()
            command.linear.x = linear * self.get_parameter("scale_linear").value
            command.angular.z = angular * self.get_parameter("scale_angular").value
            self._commands.publish(command)
        elif key in _EIGHTHS and self._rotating.server_is_ready():
            goal = RotateAbsolute.Goal(theta=_EIGHTHS[key] * math.pi / 4)
            self._rotating.send_goal_async(goal).add_done_callback(self._accepted)
        elif key == b"f" and self._goal:
            self._goal.cancel_goal_async()

    def _accepted(self, answer: Future) -> None:
        self._goal = answer.result()


@contextmanager
def _single_keys(terminal: int) -> Iterator[None]:
    """Keys arrive as they are pressed, and are not shown."""
    before = termios.tcgetattr(terminal)
    without = termios.tcgetattr(terminal)
    without[3] &= ~(termios.ICANON | termios.ECHO)
    termios.tcsetattr(terminal, termios.TCSANOW, without)
    try:
        yield
    finally:
        termios.tcsetattr(terminal, termios.TCSANOW, before)


def _keys(typed: bytes) -> Iterator[bytes]:
    """Single keys; an arrow is three bytes."""
    while typed:
        length = 3 if typed[:3] in _ARROWS else 1
        yield typed[:length].lower() if length == 1 else typed[:length]
        typed = typed[length:]


def _drive(node: Teleop, terminal: int) -> None:
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0)
        if not select.select([terminal], [], [], 0.02)[0]:
            continue
        if not (typed := os.read(terminal, 64)):
            return
        for key in _keys(typed):
            if key == b"q":
                return
            node.press(key)


def main(args: Sequence[str] | None = None) -> None:
    """Read keys until Q or Ctrl+C."""
    if not sys.stdin.isatty():
        sys.exit(
            "turtle_teleop_key reads keys, so run it in a terminal of its own, not through `ros2 launch`."
        )
    terminal = sys.stdin.fileno()
    with running(Teleop, args) as node, _single_keys(terminal):
        print(_HELP, end="", flush=True)
        _drive(node, terminal)


if __name__ == "__main__":
    main()

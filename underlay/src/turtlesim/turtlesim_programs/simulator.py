"""The simulator: turtles on a canvas, which it draws in its terminal."""

from __future__ import annotations

import sys
from collections.abc import Sequence

import rclpy
from demo_nodes_py.running import running
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor
from rclpy.clock import Clock, ClockType
from rclpy.exceptions import InvalidTopicNameException
from rclpy.node import Node
from rclpy.validate_topic_name import validate_topic_name
from std_srvs.srv import Empty
from turtlesim.srv import Kill, Spawn

from turtlesim_programs.canvas import SIZE, Canvas
from turtlesim_programs.screen import Screen
from turtlesim_programs.turtle import Turtle

_UPDATE_S = 0.016
_DRAW_S = 0.1
_BACKGROUND = {"red": 0x45, "green": 0x56, "blue": 0xFF}


class Simulator(Node):
    """The node `turtlesim`."""

    def __init__(self) -> None:
        super().__init__("turtlesim")
        self.screen = Screen(sys.stdout)
        self._declare_parameters()
        self._canvas = Canvas()
        self._turtles: dict[str, Turtle] = {}
        self._number = 0
        self._offered = [
            self.create_service(Empty, "clear", self._clear),
            self.create_service(Empty, "reset", self._reset),
            self.create_service(Spawn, "spawn", self._spawn),
            self.create_service(Kill, "kill", self._kill),
        ]
        self.get_logger().info(f"Starting turtlesim with node name {self.get_fully_qualified_name()}")
        self._spawn_in_the_middle()
        steady = Clock(clock_type=ClockType.STEADY_TIME)
        self._updating = self.create_timer(_UPDATE_S, self._update, clock=steady)
        self._drawing = self.create_timer(_DRAW_S, self._draw, clock=steady)

    def _declare_parameters(self) -> None:
        channel = [IntegerRange(from_value=0, to_value=255, step=1)]
        for color, value in _BACKGROUND.items():
            about = f"{color.capitalize()} channel of the background color"
            descriptor = ParameterDescriptor(description=about, integer_range=channel)
            self.declare_parameter(f"background_{color[0]}", value, descriptor)
        about = "Whether turtles can also move sideways (linear.y)"
        self.declare_parameter("holonomic", False, ParameterDescriptor(description=about))

    def _update(self) -> None:
        for turtle in self._turtles.values():
            turtle.update(_UPDATE_S)

    def _draw(self) -> None:
        red, green, blue = (self.get_parameter(f"background_{color[0]}").value for color in _BACKGROUND)
        turtles = [(turtle.x, turtle.y, turtle.theta) for turtle in self._turtles.values()]
        self.screen.draw(lambda height: self._canvas.picture(height, (red, green, blue), turtles))

    def _clear(self, request: Empty.Request, response: Empty.Response) -> Empty.Response:
        self.get_logger().info("Clearing turtlesim.")
        self._canvas.clear()
        return response

    def _reset(self, request: Empty.Request, response: Empty.Response) -> Empty.Response:
        self.get_logger().info("Resetting turtlesim.")
        for name in list(self._turtles):
            self._turtles.pop(name).destroy()
        self._number = 0
        self._spawn_in_the_middle()
        self._canvas.clear()
        return response

    def _spawn(self, request: Spawn.Request, response: Spawn.Response) -> Spawn.Response:
        name = request.name or self._free_name()
        if name in self._turtles:
            self.get_logger().error(f"A turtle named [{name}] already exists")
            return response
        try:
            validate_topic_name(name)
        except InvalidTopicNameException as error:
            self.get_logger().error(f"A turtle cannot be named [{name}]: {error}")
            return response
        self._add(name, (request.x, request.y, request.theta))
        response.name = name
        return response

    def _kill(self, request: Kill.Request, response: Kill.Response) -> Kill.Response:
        if turtle := self._turtles.pop(request.name, None):
            turtle.destroy()
        else:
            self.get_logger().error(f"Tried to kill turtle [{request.name}], which does not exist")
        return response

    def _spawn_in_the_middle(self) -> None:
        self._add(self._free_name(), (SIZE / 2, SIZE / 2, 0.0))

    def _free_name(self) -> str:
        while True:
            self._number += 1
            if (name := f"turtle{self._number}") not in self._turtles:
                return name

    def _add(self, name: str, pose: tuple[float, float, float]) -> None:
        self._turtles[name] = Turtle(self, name, self._canvas, pose)
        where = "x=[{:f}], y=[{:f}], theta=[{:f}]".format(*pose)
        self.get_logger().info(f"Spawning turtle [{name}] at {where}")


def main(args: Sequence[str] | None = None) -> None:
    """Run the simulator until it is interrupted."""
    with running(Simulator, args) as node:
        try:
            rclpy.spin(node)
        finally:
            node.screen.close()


if __name__ == "__main__":
    main()

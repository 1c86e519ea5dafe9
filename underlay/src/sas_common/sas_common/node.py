"""The beginning and the end of a program, and its node."""

from __future__ import annotations

import rclpy
from rclpy.impl.implementation_singleton import rclpy_implementation
from rclpy.node import Node


class rclcpp_Node(Node):
    """A node with this name, which takes remappings and parameters from the command line."""

    def __init__(self, node_name: str, namespace: str = "") -> None:
        super().__init__(node_name, namespace=namespace or None)


def rclcpp_init() -> None:
    """Start ROS for this program; from then on Ctrl+C shuts it down, and raises KeyboardInterrupt as ever."""
    rclpy.init()


def rclcpp_ok() -> bool:
    """Whether ROS was started and not shut down yet."""
    return rclpy.ok()


def rclcpp_shutdown() -> None:
    """End ROS for this program; does nothing if that was done already."""
    try:
        rclpy.try_shutdown()
    except rclpy_implementation.RCLError:
        # Ctrl+C did it meanwhile, in another thread.
        if rclpy.ok():
            raise

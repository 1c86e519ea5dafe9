"""What happens to a loop when ROS is shut down under it, by Ctrl+C for one."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from rclpy.exceptions import InvalidHandle
from rclpy.executors import ExternalShutdownException, ShutdownException
from rclpy.impl.implementation_singleton import rclpy_implementation
from rclpy.node import Node


@contextmanager
def quiet_after_shutdown(node: Node) -> Iterator[None]:
    """What is asked of a ROS that was shut down does nothing, as in C++; other errors stay errors."""
    try:
        yield
    except (ShutdownException, ExternalShutdownException):
        pass
    except (InvalidHandle, rclpy_implementation.RCLError):
        if node.context.ok():
            raise

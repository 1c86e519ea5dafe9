"""How these nodes begin and end."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.impl.implementation_singleton import rclpy_implementation
from rclpy.node import Node


@contextmanager
def running(make_node: Callable[[], Node], args: Sequence[str] | None) -> Iterator[Node]:
    """Make the node, and take it down at the end, which Ctrl+C is one way to reach."""
    rclpy.init(args=args)
    try:
        node = make_node()
        yield node
        node.destroy_node()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        _shut_down()


def _shut_down() -> None:
    try:
        rclpy.try_shutdown()
    except rclpy_implementation.RCLError:
        # Ctrl+C did it meanwhile, in another thread.
        if rclpy.ok():
            raise

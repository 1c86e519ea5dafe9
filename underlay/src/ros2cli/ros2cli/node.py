"""A node of rclpy for the verbs that talk to others, hidden from listings and without services of its own."""

from __future__ import annotations

import contextlib
import time
from argparse import Namespace
from collections.abc import Callable, Iterator
from typing import Any

import rclpy
from rclpy.impl.implementation_singleton import rclpy_implementation
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.signals import SignalHandlerOptions

from ros2cli.errors import TERMINATED, CommandError
from ros2cli.rcl import Handle, extension, hidden_name

_STEP = 0.005


@contextlib.contextmanager
def own_node(args: Namespace | None = None, name: str = "", *, survives: bool = False) -> Iterator[Node]:
    """Created for one command, and taken out of the graph at its end.

    One that `survives` Ctrl+C can still talk to others while KeyboardInterrupt is dealt with; rclpy's own
    handling of signals ends a node at once.
    """
    # The command line is ours: a rule in it, such as that of a component, is for somebody else.
    rclpy.init(args=[], signal_handler_options=SignalHandlerOptions.NO if survives else None)
    node = Node(
        name or hidden_name(),
        start_parameter_services=False,
        parameter_overrides=_overrides(args),
        automatically_declare_parameters_from_overrides=False,
    )
    try:
        yield node
    except Exception as error:
        if survives or node.context.ok():
            raise
        # A signal took the context away, under whatever was being asked of it.
        raise CommandError("", TERMINATED) from error
    finally:
        node.destroy_node()
        _shut_down()


def _shut_down() -> None:
    try:
        rclpy.try_shutdown()
    except rclpy_implementation.RCLError:
        # A signal did it meanwhile, in another thread.
        if rclpy.ok():
            raise


def handle_of(node: Node) -> Handle:
    """The node as the quick functions want it."""
    return Handle(extension(), node.context.handle, node.handle)


def wait_until(condition: Callable[[], Any], timeout: float | None = None) -> bool:
    """Look again and again whether something has become true that rclpy tells no event of."""
    end = None if timeout is None else time.monotonic() + timeout
    while not condition():
        if end is not None and time.monotonic() > end:
            return False
        time.sleep(_STEP)
    return True


def _overrides(args: Namespace | None) -> list[Parameter]:
    return [Parameter("use_sim_time", value=True)] if getattr(args, "use_sim_time", False) else []

"""The time that `--use-sim-time` asks for: that of /clock, heard by a node of its own in the background."""

from __future__ import annotations

import contextlib
import threading
from argparse import Namespace
from collections.abc import Iterator
from typing import Any


@contextlib.contextmanager
def clock_of(args: Namespace, node: Any) -> Iterator[Any]:
    """The clock of rclpy to go by. Simulation time is 0 until somebody tells it."""
    if not args.use_sim_time:
        yield node.get_clock()
        return
    from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
    from rclpy.node import Node
    from rclpy.parameter import Parameter

    listener = Node(
        f"{node.get_name()}_clock",
        start_parameter_services=False,
        parameter_overrides=[Parameter("use_sim_time", value=True)],
    )
    executor = SingleThreadedExecutor()
    executor.add_node(listener)

    def spin() -> None:
        with contextlib.suppress(ExternalShutdownException):
            executor.spin()

    thread = threading.Thread(target=spin, daemon=True)
    thread.start()
    try:
        yield listener.get_clock()
    finally:
        executor.shutdown()
        thread.join()
        listener.destroy_node()


def seconds(clock: Any) -> float:
    return float(clock.now().nanoseconds) / 1e9

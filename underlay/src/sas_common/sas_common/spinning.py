"""Doing what has come in for a node, without waiting for more."""

from __future__ import annotations

from collections.abc import Iterator

import rclpy
from rclpy.executors import Executor, TimeoutException
from rclpy.node import Node
from rclpy.task import Task

from sas_common.ending import quiet_after_shutdown


def rclcpp_spin_some(node: Node) -> None:
    """Call the callbacks of whatever has come in for the node; what they raise is raised here.

    Returns at once when nothing has, and when ROS was shut down. rclpy's own spin_once does one callback a
    call, so a loop would fall behind a robot that tells more than the loop asks.
    """
    if not node.context.ok():
        return
    executor = rclpy.get_global_executor()
    executor.add_node(node)
    for task in _ready(executor, node):
        task()
        task.result()


def _ready(executor: Executor, node: Node) -> Iterator[Task]:
    """What is ready at this moment, each once: without a time to wait, rclpy looks once."""
    with quiet_after_shutdown(node):
        while True:
            try:
                task, _, _ = executor.wait_for_ready_callbacks(timeout_sec=0.0, nodes=[node])
            except TimeoutException:
                return
            yield task

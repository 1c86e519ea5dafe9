"""What `check 18-publisher` watches, written by hand for `launch_test`; bench/check.py runs it."""

from __future__ import annotations

import time
import unittest
from itertools import pairwise
from typing import Any

import launch
import launch_testing
import rclpy
from launch_ros.actions import Node
from package_with_interfaces.msg import AmazingQuote

TOPIC, NODE, ENOUGH, PERIOD = "/amazing_quote", "amazing_quote_publisher_node", 5, 0.5


def generate_test_description() -> tuple[launch.LaunchDescription, dict[str, Any]]:
    node = Node(package="python_package_that_uses_the_messages", executable=NODE, sigterm_timeout="5")
    ready = launch_testing.actions.ReadyToTest()
    return launch.LaunchDescription([node, ready]), {"node": node}


class TestPublisher(unittest.TestCase):
    def test_it(self) -> None:
        received: list[tuple[float, AmazingQuote]] = []
        rclpy.init()
        watching = rclpy.create_node("watching")
        watching.create_subscription(
            AmazingQuote, TOPIC, lambda message: received.append((time.monotonic(), message)), 10
        )
        until = time.monotonic() + 20
        while len(received) < ENOUGH and time.monotonic() < until:
            rclpy.spin_once(watching, timeout_sec=0.1)
        names, types = watching.get_node_names(), dict(watching.get_topic_names_and_types())
        watching.destroy_node()
        rclpy.shutdown()
        assert NODE in names
        assert types[TOPIC] == ["package_with_interfaces/msg/AmazingQuote"]
        assert len(received) >= ENOUGH
        gaps = [after - before for (before, _), (after, _) in pairwise(received)]
        assert abs(sum(gaps) / len(gaps) - PERIOD) < 0.1
        assert all(after.id == before.id + 1 for (_, before), (_, after) in pairwise(received))
        assert all(message.quote and message.philosopher_name for _, message in received)


@launch_testing.post_shutdown_test()
class TestEnd(unittest.TestCase):
    def test_exit_code(self, proc_info: Any) -> None:
        launch_testing.asserts.assertExitCodes(proc_info)

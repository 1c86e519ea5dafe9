"""What both clients of the service do first."""

from __future__ import annotations

from example_interfaces.srv import AddTwoInts
from rclpy.node import Node
from rclpy.task import Future


def ask_for_sum(node: Node, a: int, b: int) -> Future:
    """Wait for the service `add_two_ints` and ask it for a sum; the answer will be in what is returned."""
    client = node.create_client(AddTwoInts, "add_two_ints")
    while not client.wait_for_service(timeout_sec=1.0):
        node.get_logger().info("service not available, waiting again...")
    return client.call_async(AddTwoInts.Request(a=a, b=b))


def tell_sum(node: Node, answer: Future) -> None:
    """Log the sum, or why there is none."""
    if answer.exception() is not None:
        node.get_logger().error(f"Exception while calling service: {answer.exception()!r}")
    else:
        node.get_logger().info(f"Result of add_two_ints: {answer.result().sum}")

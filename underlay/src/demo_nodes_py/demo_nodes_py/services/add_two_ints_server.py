"""Adds two whole numbers for anyone who asks."""

from __future__ import annotations

from collections.abc import Sequence

import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.node import Node

from demo_nodes_py.running import running


class AddTwoIntsServer(Node):
    """Offers the service `add_two_ints`."""

    def __init__(self) -> None:
        super().__init__("add_two_ints_server")
        self._service = self.create_service(AddTwoInts, "add_two_ints", self._add)

    def _add(self, request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        response.sum = request.a + request.b
        self.get_logger().info(f"Incoming request\na: {request.a} b: {request.b}")
        return response


def main(args: Sequence[str] | None = None) -> None:
    """Run the node until it is interrupted."""
    with running(AddTwoIntsServer, args) as node:
        rclpy.spin(node)


if __name__ == "__main__":
    main()

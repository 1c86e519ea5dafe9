"""Asks for the sum of 2 and 3, and waits for the answer."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import rclpy
from rclpy.node import Node

from demo_nodes_py.running import running
from demo_nodes_py.services.asking import ask_for_sum, tell_sum


def main(args: Sequence[str] | None = None) -> None:
    """Ask once."""
    with running(partial(Node, "add_two_ints_client"), args) as node:
        answer = ask_for_sum(node, 2, 3)
        rclpy.spin_until_future_complete(node, answer)
        tell_sum(node, answer)


if __name__ == "__main__":
    main()

"""Asks for the sum of 2 and 3, and does other things until the answer is there."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import rclpy
from rclpy.node import Node

from demo_nodes_py.running import running
from demo_nodes_py.services.asking import ask_for_sum, tell_sum


def main(args: Sequence[str] | None = None) -> None:
    """Ask once."""
    with running(partial(Node, "add_two_ints_client_async"), args) as node:
        answer = ask_for_sum(node, 2, 3)
        while rclpy.ok() and not answer.done():
            rclpy.spin_once(node, timeout_sec=0.1)  # between two of these there is time for other work
        if answer.done():
            tell_sum(node, answer)


if __name__ == "__main__":
    main()

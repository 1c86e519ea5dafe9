"""`ros2 lifecycle get`."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from typing import Any

from ros2cli.errors import CommandError
from ros2cli.lifecycle import add_node_arguments, asked_node, call, seen_nodes


def add_arguments(parser: ArgumentParser) -> None:
    text = "Name of the ROS node; without it, the states of all nodes are told"
    add_node_arguments(parser, nargs="?", help=text)


def main(args: Namespace) -> None:
    from ros2cli.node import own_node

    if args.node_name is not None:
        name = asked_node(args)
        with own_node(args) as node:
            print(_state(node, name))
        return
    names = seen_nodes(args)
    with own_node(args) as node:
        for name in names:
            _print_state(node, name)


def _print_state(node: Any, name: str) -> None:
    """Of one among several: one that does not answer keeps nobody from hearing of the others."""
    try:
        print(f"{name}: {_state(node, name)}")
    except CommandError as error:
        print(f"Exception while calling service of node '{name}': {error}", file=sys.stderr)


def _state(node: Any, name: str) -> str:
    from lifecycle_msgs.srv import GetState

    state = call(node, GetState, f"{name}/get_state").current_state
    return f"{state.label} [{state.id}]"

"""`ros2 lifecycle set`."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from typing import Any

from ros2cli.errors import CommandError
from ros2cli.lifecycle import add_node_arguments, asked_node, call, transitions


def add_arguments(parser: ArgumentParser) -> None:
    add_node_arguments(parser)
    parser.add_argument("transition", help="The lifecycle transition: its name or its number")


def main(args: Namespace) -> None:
    from lifecycle_msgs.srv import ChangeState

    from ros2cli.node import own_node

    name = asked_node(args)
    with own_node(args) as node:
        chosen = _chosen([told.transition for told in transitions(node, name)], args.transition)
        if call(node, ChangeState, f"{name}/change_state", transition=chosen).success:
            print("Transitioning successful")
        else:
            print("Transitioning failed", file=sys.stderr)


def _chosen(possible: Sequence[Any], asked: str) -> Any:
    """The transition of this name, else the one of this number."""
    for one in possible:
        if one.label == asked:
            return one
    for one in possible:
        if str(one.id) == asked:
            return one
    listed = "".join(f"\n- {one.label} [{one.id}]" for one in possible)
    raise CommandError(f"Unknown transition requested, available ones are:{listed}")

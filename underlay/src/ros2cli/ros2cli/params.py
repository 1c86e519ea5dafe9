"""What the verbs of `ros2 param` have in common: their arguments, and asking the services of a node."""

from __future__ import annotations

import contextlib
from argparse import ArgumentParser, Namespace
from collections.abc import Iterator
from typing import Any

from ros2cli.arguments import add_completed, add_hidden
from ros2cli.complete import node_names
from ros2cli.errors import CommandError
from ros2cli.graph import add_graph_arguments

_DEFAULT_TIMEOUT = 5.0


def add_param_arguments(parser: ArgumentParser) -> None:
    add_graph_arguments(parser)
    add_hidden(parser, "nodes")


def add_node_argument(parser: ArgumentParser, **options: Any) -> None:
    add_completed(parser, "node_name", node_names, help="Name of the ROS node", **options)


def add_timeout(parser: ArgumentParser) -> None:
    text = "Wait for N seconds until node becomes available (default %(default)s seconds)"
    parser.add_argument("--timeout", metavar="N", type=float, default=_DEFAULT_TIMEOUT, help=text)


def parameter_names(prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
    """For the Tab key: the names that the node named before has."""
    with contextlib.suppress(CommandError), remote_node(parsed_args) as remote:
        return remote.list_names()
    return []


@contextlib.contextmanager
def remote_node(args: Namespace) -> Iterator[Any]:
    """A RemoteNode for the node that the command line names."""
    from ros2cli.node import own_node
    from ros2cli.remote_node import RemoteNode

    name = args.node_name if args.node_name.startswith("/") else f"/{args.node_name}"
    with own_node(args) as node:
        yield RemoteNode(node, name, getattr(args, "timeout", _DEFAULT_TIMEOUT), args.spin_time)

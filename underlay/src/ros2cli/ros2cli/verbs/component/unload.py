"""`ros2 component unload`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.components import add_container_argument, asked_container, call
from ros2cli.graph import add_graph_arguments


def add_arguments(parser: ArgumentParser) -> None:
    add_graph_arguments(parser)
    add_container_argument(parser, help="Container node name to unload component from")
    text = "Unique ID of the component to be unloaded"
    parser.add_argument("component_uid", type=int, nargs="+", help=text)
    parser.add_argument("-q", "--quiet", action="store_true", help="Only print component unique IDs")


def main(args: Namespace) -> str | None:
    from ros2cli.node import own_node

    container = asked_container(args)
    with own_node(args) as node:
        for number in args.component_uid:
            response = call(node, container, "unload_node", unique_id=number)
            if not response.success:
                reason = response.error_message.capitalize()
                return f"Failed to unload component {number} from '{container}' container node\n    {reason}"
            text = f"Unloaded component {number} from '{container}' container node"
            print(number if args.quiet else text)
    return None

"""`ros2 component load`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.components import add_component_arguments, add_container_argument, asked_container, load
from ros2cli.graph import add_graph_arguments


def add_arguments(parser: ArgumentParser) -> None:
    add_graph_arguments(parser)
    add_container_argument(parser, help="Container node name to load component into")
    add_component_arguments(parser)
    parser.add_argument(
        "-q", "--quiet", action="store_true", help="Only print component unique IDs and names"
    )


def main(args: Namespace) -> None:
    from ros2cli.node import own_node

    container = asked_container(args)
    with own_node(args) as node:
        number, name = load(node, container, args)
    if args.quiet:
        print(f"{number}  {name}")
    else:
        print(f"Loaded component {number} into '{container}' container node as '{name}'")

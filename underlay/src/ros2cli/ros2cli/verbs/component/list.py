"""`ros2 component list`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import Any

from ros2cli.components import add_container_argument, asked_container, containers, loaded
from ros2cli.errors import CommandError
from ros2cli.graph import add_graph_arguments, graph


def add_arguments(parser: ArgumentParser) -> None:
    add_graph_arguments(parser)
    text = "Name of the container node to list components from"
    add_container_argument(parser, nargs="?", help=text)
    parser.add_argument("--containers-only", action="store_true", help="List found containers nodes only")


def main(args: Namespace) -> None:
    names = containers(graph(args)) if args.container_node_name is None else [asked_container(args)]
    if args.containers_only:
        if args.container_node_name is None:
            print("".join(f"{name}\n" for name in names), end="")
        return
    from ros2cli.node import own_node

    with own_node(args) as node:
        if args.container_node_name is not None:
            _print_components(node, *names)
            return
        for name in names:
            print(name)
            _print_indented(node, name)


def _print_components(node: Any, container: str, indent: str = "") -> None:
    for number, name in loaded(node, container):
        print(f"{indent}{number}  {name}")


def _print_indented(node: Any, container: str) -> None:
    """One that does not answer keeps nobody from hearing of the others."""
    try:
        _print_components(node, container, "  ")
    except CommandError as error:
        print(f"{error} when listing components")

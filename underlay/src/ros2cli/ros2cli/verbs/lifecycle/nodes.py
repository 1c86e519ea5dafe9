"""`ros2 lifecycle nodes`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.graph import add_graph_arguments, graph
from ros2cli.lifecycle import managed_nodes


def add_arguments(parser: ArgumentParser) -> None:
    add_graph_arguments(parser)
    parser.add_argument("-a", "--all", action="store_true", help="Display all nodes even hidden ones")
    parser.add_argument(
        "-c", "--count-nodes", action="store_true", help="Only display the number of nodes discovered"
    )


def main(args: Namespace) -> None:
    nodes = managed_nodes(graph(args), hidden=args.all)
    print(len(nodes)) if args.count_nodes else print("".join(f"{node}\n" for node in nodes), end="")

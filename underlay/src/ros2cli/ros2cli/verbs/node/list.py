"""`ros2 node list`."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace

from ros2cli.graph import add_graph_arguments, graph
from ros2cli.snapshot import is_hidden


def add_arguments(parser: ArgumentParser) -> None:
    add_graph_arguments(parser)
    parser.add_argument("-a", "--all", action="store_true", help="Display all nodes even hidden ones")
    parser.add_argument(
        "-c", "--count-nodes", action="store_true", help="Only display the number of nodes discovered"
    )


def main(args: Namespace) -> None:
    nodes = [node for node in graph(args).nodes if args.all or not is_hidden(node)]
    if args.count_nodes:
        print(len(nodes))
        return
    if len(set(nodes)) < len(nodes):
        print(
            "WARNING: Be aware that there are nodes in the graph that share an exact name, which can have "
            "unintended side effects.",
            file=sys.stderr,
        )
    for node in nodes:
        print(node)

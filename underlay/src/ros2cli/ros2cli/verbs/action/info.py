"""`ros2 action info`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.actions import nodes_with
from ros2cli.arguments import add_completed
from ros2cli.complete import action_names
from ros2cli.graph import graph


def add_arguments(parser: ArgumentParser) -> None:
    text = "Name of the ROS action to get info (e.g. '/fibonacci')"
    add_completed(parser, "action_name", action_names, help=text)
    parser.add_argument("-t", "--show-types", action="store_true", help="Additionally show the action type")
    parser.add_argument(
        "-c", "--count", action="store_true", help="Only display the number of action clients and servers"
    )


def main(args: Namespace) -> None:
    known, name = graph(args), args.action_name
    print(f"Action: {name}")
    for title, servers in (("Action clients", False), ("Action servers", True)):
        nodes = nodes_with(known, name, servers=servers)
        print(f"{title}: {len(nodes)}")
        for node, types in nodes if not args.count else ():
            print(f"    {node} [{', '.join(types)}]" if args.show_types else f"    {node}")

"""`ros2 topic type`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.arguments import add_completed
from ros2cli.complete import topic_names
from ros2cli.graph import add_graph_arguments, graph


def add_arguments(parser: ArgumentParser) -> None:
    add_graph_arguments(parser)
    add_completed(
        parser, "topic_name", topic_names, help="Name of the ROS topic to get type (e.g. '/chatter')"
    )


def main(args: Namespace) -> int:
    types = graph(args).topics(hidden=True).get(args.topic_name, [])
    for name in types:
        print(name)
    return 0 if types else 1

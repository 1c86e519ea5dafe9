"""`ros2 action type`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.actions import actions
from ros2cli.arguments import add_completed
from ros2cli.complete import action_names
from ros2cli.graph import graph


def add_arguments(parser: ArgumentParser) -> None:
    text = "Name of the ROS action to get type (e.g. '/fibonacci')"
    add_completed(parser, "action_name", action_names, help=text)


def main(args: Namespace) -> int:
    types = actions(graph(args)).get(args.action_name, [])
    for name in types:
        print(name)
    return 0 if types else 1

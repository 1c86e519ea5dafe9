"""`ros2 service type`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.arguments import add_completed
from ros2cli.complete import service_names
from ros2cli.graph import graph


def add_arguments(parser: ArgumentParser) -> None:
    text = "Name of the ROS service to get type (e.g. '/add_two_ints')"
    add_completed(parser, "service_name", service_names, help=text)


def main(args: Namespace) -> int:
    types = graph(args).services(hidden=True).get(args.service_name, [])
    for name in types:
        print(name)
    return 0 if types else 1

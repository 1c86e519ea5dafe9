"""`ros2 service info`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.arguments import add_completed
from ros2cli.complete import service_names
from ros2cli.graph import add_graph_arguments, graph


def add_arguments(parser: ArgumentParser) -> None:
    add_graph_arguments(parser)
    text = "Name of the ROS service to get info (e.g. '/add_two_ints')"
    add_completed(parser, "service_name", service_names, help=text)


def main(args: Namespace) -> str | None:
    known, name = graph(args), args.service_name
    types = known.services(hidden=True).get(name)
    if types is None:
        return f"Unknown service '{name}'"
    print(f"Type: {types[0] if len(types) == 1 else types}")
    print(f"Clients count: {len(known.clients(name))}")
    print(f"Services count: {len(known.servers(name))}")
    return None

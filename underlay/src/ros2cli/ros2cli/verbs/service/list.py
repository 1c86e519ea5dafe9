"""`ros2 service list`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.arguments import add_hidden
from ros2cli.graph import add_graph_arguments, graph


def add_arguments(parser: ArgumentParser) -> None:
    add_graph_arguments(parser)
    parser.add_argument("-t", "--show-types", action="store_true", help="Additionally show the service type")
    parser.add_argument(
        "-c", "--count-services", action="store_true", help="Only display the number of services discovered"
    )
    add_hidden(parser, "services")


def main(args: Namespace) -> None:
    services = graph(args).services(hidden=args.include_hidden_services)
    if args.count_services:
        print(len(services))
        return
    for name, types in services.items():
        print(f"{name} [{', '.join(types)}]" if args.show_types else name)

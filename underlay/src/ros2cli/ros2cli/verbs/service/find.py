"""`ros2 service find`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.arguments import add_hidden
from ros2cli.graph import graph


def add_arguments(parser: ArgumentParser) -> None:
    text = "Name of the ROS service type to filter for (e.g. 'std_srvs/srv/Empty')"
    parser.add_argument("service_type", help=text)
    parser.add_argument(
        "-c", "--count-services", action="store_true", help="Only display the number of services discovered"
    )
    add_hidden(parser, "services")


def main(args: Namespace) -> None:
    services = graph(args).services(hidden=args.include_hidden_services)
    found = [name for name, types in services.items() if args.service_type in types]
    print(len(found)) if args.count_services else print("".join(f"{name}\n" for name in found), end="")

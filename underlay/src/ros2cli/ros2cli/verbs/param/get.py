"""`ros2 param get`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.arguments import add_completed
from ros2cli.param_types import kind, value_of
from ros2cli.params import add_node_argument, add_param_arguments, add_timeout, parameter_names, remote_node


def add_arguments(parser: ArgumentParser) -> None:
    add_param_arguments(parser)
    add_node_argument(parser)
    add_completed(parser, "parameter_name", parameter_names, help="Name of the parameter")
    parser.add_argument("--hide-type", action="store_true", help="Hide the type information")
    add_timeout(parser)


def main(args: Namespace) -> str | None:
    with remote_node(args) as remote:
        values = remote.get([args.parameter_name])
    if not values or not values[0].type:
        return "Parameter not set"
    label = "" if args.hide_type else f"{kind(values[0].type).label} "
    print(f"{label}{value_of(values[0])}")
    return None

"""`ros2 param set`."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace

from ros2cli.arguments import add_completed
from ros2cli.params import add_node_argument, add_param_arguments, add_timeout, parameter_names, remote_node


def add_arguments(parser: ArgumentParser) -> None:
    add_param_arguments(parser)
    add_node_argument(parser)
    add_completed(parser, "parameter_name", parameter_names, help="Name of the parameter")
    parser.add_argument("value", help="Value of the parameter")
    add_timeout(parser)


def main(args: Namespace) -> None:
    from rcl_interfaces.msg import Parameter

    from ros2cli.param_values import guessed_value

    parameter = Parameter(name=args.parameter_name, value=guessed_value(args.value))
    with remote_node(args) as remote:
        (result,) = remote.set([parameter])
    reason = f": {result.reason}" if result.reason else ""
    if result.successful:
        print(f"Set parameter successful{reason}")
    else:
        print(f"Setting parameter failed{reason}", file=sys.stderr)

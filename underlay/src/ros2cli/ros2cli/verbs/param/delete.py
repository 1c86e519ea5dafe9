"""`ros2 param delete`."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace

from ros2cli.arguments import add_completed
from ros2cli.params import add_node_argument, add_param_arguments, add_timeout, parameter_names, remote_node


def add_arguments(parser: ArgumentParser) -> None:
    add_param_arguments(parser)
    add_node_argument(parser)
    add_completed(parser, "parameter_name", parameter_names, help="Name of the parameter")
    add_timeout(parser)


def main(args: Namespace) -> None:
    from rcl_interfaces.msg import Parameter

    with remote_node(args) as remote:
        # A value without a type takes the parameter away.
        (result,) = remote.set([Parameter(name=args.parameter_name)])
    reason = f": {result.reason}" if result.reason else ""
    if result.successful:
        print(f"Deleted parameter successfully{reason}")
    else:
        print(f"Deleting parameter failed{reason}", file=sys.stderr)

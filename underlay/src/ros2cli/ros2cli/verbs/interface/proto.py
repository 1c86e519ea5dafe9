"""`ros2 interface proto`: an interface with its default values, to be filled in."""

from __future__ import annotations

import argparse
from typing import Any

from ros2cli.verbs.interface.asked_type import add_type_argument, asked_type, definition_path


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the type, and whether quotes are wanted."""
    add_type_argument(parser, 'Show an interface definition (e.g. "example_interfaces/msg/String")')
    parser.add_argument(
        "--no-quotes",
        action="store_true",
        help="if true output has no outer quotes. By default, quotes are used so that output can be "
        "tab-completed in the terminal, e.g. as values of `ros2 topic pub`.",
    )


def main(args: argparse.Namespace) -> None:
    """Print a message, a service's request or an action's goal as YAML."""
    from rosidl_runtime_py import message_to_yaml
    from rosidl_runtime_py.utilities import get_interface

    name = asked_type(args)
    definition_path(name)  # an unknown one is told here, in the words of `show`
    text = message_to_yaml(_to_fill_in(get_interface(name)))
    print(text if args.no_quotes else f'"{text}"')


def _to_fill_in(interface: Any) -> Any:
    from rosidl_runtime_py.utilities import is_action, is_service

    if is_action(interface):
        return interface.Goal()
    return interface.Request() if is_service(interface) else interface()

"""The type that `show` and `proto` are asked for."""

from __future__ import annotations

import argparse
import sys

from ros2cli.errors import CommandError
from ros2cli.verbs.interface.kinds import interface_types


def add_type_argument(parser: argparse.ArgumentParser, help_text: str) -> None:
    """Take the type; `-` reads it from the standard input."""
    argument = parser.add_argument("type", help=help_text)
    argument.completer = interface_types  # type: ignore[attr-defined]  # argcomplete's way


def asked_type(args: argparse.Namespace) -> str:
    """Return the type, from the pipe if that is where it comes from."""
    return sys.stdin.readline().strip() if args.type == "-" else str(args.type)


def definition_path(name: str) -> str:
    """Return the file that defines package/kind/Name; CommandError when there is none."""
    from rosidl_runtime_py import get_interface_path

    if len(name.split("/")) != 3:
        raise CommandError(f"Invalid name '{name}'. Expected three parts separated by '/'")
    try:
        return get_interface_path(name)
    except (LookupError, ValueError) as error:
        raise CommandError(str(error)) from None

"""`ros2 interface package`: the interfaces of one package."""

from __future__ import annotations

import argparse

from ros2cli.errors import CommandError
from ros2cli.verbs.interface.kinds import add_kind_arguments, interface_packages, wanted_folders


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the package and the kinds that are wanted."""
    add_kind_arguments(parser)
    name = parser.add_argument("package_name", help='Name of the ROS package (e.g. "example_interfaces")')
    name.completer = interface_packages  # type: ignore[attr-defined]  # argcomplete's way


def main(args: argparse.Namespace) -> None:
    """Print package/kind/Name, one a line."""
    from rosidl_runtime_py import get_interfaces

    try:
        names = get_interfaces([args.package_name]).get(args.package_name, [])
    except LookupError as error:
        raise CommandError(str(error)) from None
    for name in names:
        if name.split("/")[0] in wanted_folders(args):
            print(f"{args.package_name}/{name}")

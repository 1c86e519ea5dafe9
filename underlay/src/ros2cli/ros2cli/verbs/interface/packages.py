"""`ros2 interface packages`: the packages that offer interfaces."""

from __future__ import annotations

import argparse

from ros2cli.verbs.interface.kinds import add_kind_arguments, wanted_folders


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the kinds that a package has to offer."""
    add_kind_arguments(parser)


def main(args: argparse.Namespace) -> None:
    """Print the names."""
    from rosidl_runtime_py import get_interfaces

    folders = wanted_folders(args)
    for package, names in sorted(get_interfaces().items()):
        if any(name.split("/")[0] in folders for name in names):
            print(package)

"""`ros2 interface list`: all interfaces of all packages."""

from __future__ import annotations

import argparse

from ros2cli.verbs.interface.kinds import KINDS, add_kind_arguments, wanted_folders


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the kinds that are wanted."""
    add_kind_arguments(parser)


def main(args: argparse.Namespace) -> None:
    """Print messages, services and actions, each under its heading."""
    from rosidl_runtime_py import get_interfaces

    names = [f"{package}/{name}" for package, found in get_interfaces().items() for name in found]
    headings = {folder: heading for _, heading, folder in KINDS}
    for folder in wanted_folders(args):
        print(f"{headings[folder]}:")
        for name in sorted(name for name in names if name.split("/")[1] == folder):
            print(f"    {name}")

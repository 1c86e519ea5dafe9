"""`ros2 action list`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.actions import actions
from ros2cli.graph import graph


def add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("-t", "--show-types", action="store_true", help="Additionally show the action type")
    parser.add_argument(
        "-c", "--count-actions", action="store_true", help="Only display the number of actions discovered"
    )


def main(args: Namespace) -> None:
    found = actions(graph(args))
    if args.count_actions:
        print(len(found))
        return
    for name, types in found.items():
        print(f"{name} [{', '.join(types)}]" if args.show_types else name)

"""`ros2 lifecycle list`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.lifecycle import add_node_arguments, asked_node, transitions


def add_arguments(parser: ArgumentParser) -> None:
    add_node_arguments(parser)
    parser.add_argument("-a", "--all", action="store_true", help="Display all existing transitions")


def main(args: Namespace) -> None:
    from ros2cli.node import own_node

    name = asked_node(args)
    with own_node(args) as node:
        for told in transitions(node, name, every=args.all):
            print(f"- {told.transition.label} [{told.transition.id}]")
            print(f"\tStart: {told.start_state.label}\n\tGoal: {told.goal_state.label}")

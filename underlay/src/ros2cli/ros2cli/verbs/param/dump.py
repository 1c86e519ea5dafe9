"""`ros2 param dump`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import Any

from ros2cli.param_types import plain_value_of
from ros2cli.params import add_node_argument, add_param_arguments, add_timeout, remote_node


def add_arguments(parser: ArgumentParser) -> None:
    add_param_arguments(parser)
    add_node_argument(parser)
    add_timeout(parser)


def main(args: Namespace) -> None:
    import yaml

    with remote_node(args) as remote:
        names = remote.list_names()
        values = dict(zip(names, remote.get(names), strict=False))
    plain = {name: plain_value_of(value) for name, value in values.items() if value.type}
    file = {remote.name: {"ros__parameters": nested(plain)}}
    print(yaml.dump(file, default_flow_style=False, allow_unicode=True))


def nested(values: dict[str, Any]) -> dict[str, Any]:
    """`a.b: 1` as `a: {b: 1}`, as parameter files have it."""
    tree: dict[str, Any] = {}
    for name, value in values.items():
        *parents, last = name.split(".")
        branch = tree
        for parent in parents:
            branch = branch.setdefault(parent, {})
        branch[last] = value
    return tree

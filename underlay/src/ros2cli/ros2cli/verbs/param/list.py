"""`ros2 param list`."""

from __future__ import annotations

import re
import sys
from argparse import ArgumentParser, Namespace
from typing import Any

from ros2cli.errors import CommandError
from ros2cli.param_types import kind
from ros2cli.params import add_node_argument, add_param_arguments, remote_node

_TIMEOUT = 5.0


def add_arguments(parser: ArgumentParser) -> None:
    add_param_arguments(parser)
    add_node_argument(parser, nargs="?")
    parser.add_argument(
        "--param-prefixes", nargs="+", default=[], help="Only list parameters with the provided prefixes"
    )
    parser.add_argument(
        "--param-type", action="store_true", help="Print parameter types with parameter names"
    )
    parser.add_argument("--filter", help="Only list parameters matching the provided regex")


def main(args: Namespace) -> None:
    wanted = _pattern(args.filter)
    if args.node_name is not None:
        with remote_node(args) as remote:
            _print_names(remote, args, wanted)
        return
    _print_all(args, wanted)


def _print_all(args: Namespace, wanted: re.Pattern[str]) -> None:
    from ros2cli.discovery import discover
    from ros2cli.node import handle_of, own_node
    from ros2cli.remote_node import RemoteNode
    from ros2cli.snapshot import is_hidden

    with own_node(args) as node:
        for name in dict.fromkeys(discover(handle_of(node), args.spin_time).nodes):
            if not is_hidden(name) or (
                getattr(args, "include_hidden_nodes", False) and name != f"/{node.get_name()}"
            ):
                _print_node(RemoteNode(node, name, _TIMEOUT, args.spin_time), args, wanted)


def _print_node(remote: Any, args: Namespace, wanted: re.Pattern[str]) -> None:
    """One without parameter services, or gone meanwhile, must not keep the others from being listed."""
    try:
        _print_names(remote, args, wanted, header=f"{remote.name}:")
    except CommandError as error:
        print(f"Exception while calling service of node '{remote.name}': {error}", file=sys.stderr)


def _print_names(remote: Any, args: Namespace, wanted: re.Pattern[str], header: str = "") -> None:
    names = [name for name in remote.list_names(args.param_prefixes) if wanted.search(name)]
    types = {found.name: kind(found.type).name for found in remote.describe(names)} if args.param_type else {}
    lines = [f"  {name} (type: {types.get(name, 'unknown')})" if types else f"  {name}" for name in names]
    print("\n".join([header, *lines] if header else lines)) if header or lines else None


def _pattern(text: str | None) -> re.Pattern[str]:
    try:
        return re.compile(text or "")
    except re.error as error:
        raise CommandError(f"Invalid filter '{text}': {error}") from error

"""`ros2 node info`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.actions import action_clients_of, action_servers_of
from ros2cli.complete import node_names
from ros2cli.graph import add_graph_arguments, graph
from ros2cli.snapshot import Snapshot, is_hidden

_SEVERAL = (
    'There are {count} nodes in the graph with the exact name "{node}". '
    "You are seeing information about only one of them."
)
Found = dict[str, list[str]]


def add_arguments(parser: ArgumentParser) -> None:
    add_graph_arguments(parser)
    name = parser.add_argument("node_name", help="Fully qualified node name to request information")
    name.completer = node_names  # type: ignore[attr-defined]
    parser.add_argument(
        "--include-hidden", action="store_true", help="Display hidden topics, services, and actions as well"
    )


def main(args: Namespace) -> str | None:
    known, node = graph(args), args.node_name
    count = known.nodes.count(node)
    if not count:
        return f"Unable to find node '{node}'"
    if count > 1:
        print(_SEVERAL.format(count=count, node=node))
    print(node)
    for title, found in _sections(known, node):
        shown = {name: types for name, types in found.items() if args.include_hidden or not is_hidden(name)}
        print(f"  {title}:")
        # An empty list is an empty line.
        print("\n".join(f"    {name}: {', '.join(types)}" for name, types in shown.items()))
    return None


def _sections(known: Snapshot, node: str) -> list[tuple[str, Found]]:
    return [
        ("Subscribers", known.of_node(node, "topic", writes=False)),
        ("Publishers", known.of_node(node, "topic", writes=True)),
        ("Service Servers", known.of_node(node, "request", writes=False)),
        ("Service Clients", known.of_node(node, "request", writes=True)),
        ("Action Servers", action_servers_of(known, node)),
        ("Action Clients", action_clients_of(known, node)),
    ]

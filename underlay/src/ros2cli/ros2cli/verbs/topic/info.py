"""`ros2 topic info`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.arguments import add_completed
from ros2cli.complete import topic_names
from ros2cli.graph import add_graph_arguments, graph
from ros2cli.qos_text import qos_lines
from ros2cli.snapshot import Endpoint


def add_arguments(parser: ArgumentParser) -> None:
    add_graph_arguments(parser)
    add_completed(
        parser, "topic_name", topic_names, help="Name of the ROS topic to get info (e.g. '/chatter')"
    )
    parser.add_argument(
        "-v", "--verbose", action="store_true",
        help="Prints detailed information like the node name, node namespace, topic type, topic type hash, "
        "GUID, and QoS Profile of the publishers and subscribers to this topic",
    )  # fmt: skip


def main(args: Namespace) -> str | None:
    known, name = graph(args), args.topic_name
    types = known.topics(hidden=True).get(name)
    if types is None:
        return f"Unknown topic '{name}'"
    print(f"Type: {types[0] if len(types) == 1 else types}", end="\n\n" if args.verbose else "\n")
    for title, ends in (("Publisher", known.publishers(name)), ("Subscription", known.subscriptions(name))):
        print(f"{title} count: {len(ends)}", end="\n\n" if args.verbose else "\n")
        for end in ends if args.verbose else ():
            print("\n".join(_details(end)), end="\n\n")
    return None


def _details(end: Endpoint) -> list[str]:
    return [
        f"Node name: {end.node}",
        f"Node namespace: {end.namespace}",
        f"Topic type: {end.type}",
        f"Topic type hash: {end.type_hash}",
        f"Endpoint type: {'PUBLISHER' if end.writes else 'SUBSCRIPTION'}",
        f"GID: {'.'.join(f'{byte:02x}' for byte in end.gid)}",
        "QoS profile:",
        *(f"  {line}" for line in qos_lines(end.qos)),
    ]

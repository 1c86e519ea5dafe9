"""What the verbs of `ros2 lifecycle` have in common: who has states, and asking them."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import Any

from ros2cli.arguments import add_completed, add_hidden
from ros2cli.errors import CommandError
from ros2cli.graph import add_graph_arguments, graph
from ros2cli.snapshot import Snapshot, is_hidden

_TIMEOUT = 5.0


def managed_nodes(known: Snapshot, *, hidden: bool) -> list[str]:
    """The names of the nodes that tell their state."""
    services = known.services(hidden=True)
    found = {
        node for node in known.nodes if "lifecycle_msgs/srv/GetState" in services.get(f"{node}/get_state", ())
    }
    return sorted(node for node in found if hidden or not is_hidden(node))


def add_node_arguments(parser: ArgumentParser, **options: Any) -> None:
    add_graph_arguments(parser)
    options = {"help": "Name of the ROS node", **options}
    add_completed(parser, "node_name", _names, **options)
    add_hidden(parser, "nodes")


def asked_node(args: Namespace) -> str:
    """The full name of the node of the command line, which has states; else CommandError."""
    name = args.node_name if args.node_name.startswith("/") else f"/{args.node_name}"
    if name not in seen_nodes(args):
        raise CommandError("Node not found")
    return str(name)


def seen_nodes(args: Namespace) -> list[str]:
    return managed_nodes(graph(args), hidden=getattr(args, "include_hidden_nodes", False))


def call(node: Any, kind: Any, service: str, **request: Any) -> Any:
    """The response; CommandError for a node that does not answer."""
    import rclpy

    from ros2cli.node import wait_until

    client = node.create_client(kind, service)
    future = None
    if wait_until(client.service_is_ready, _TIMEOUT):
        future = client.call_async(kind.Request(**request))
        rclpy.spin_until_future_complete(node, future, timeout_sec=_TIMEOUT)
    if future is None or not future.done():
        raise CommandError(f"The service '{service}' does not answer")
    return future.result()


def transitions(node: Any, name: str, *, every: bool = False) -> list[Any]:
    """Those that may come next, or all that there are."""
    from lifecycle_msgs.srv import GetAvailableTransitions

    service = "get_transition_graph" if every else "get_available_transitions"
    return list(call(node, GetAvailableTransitions, f"{name}/{service}").available_transitions)


def _names(prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
    return seen_nodes(parsed_args)

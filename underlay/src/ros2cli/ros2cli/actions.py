"""Actions, as the topics and services show that they are made of."""

from __future__ import annotations

from collections.abc import Iterable

from ros2cli.snapshot import Endpoint, Snapshot

_FEEDBACK, _TYPE_END = "/_action/feedback", "_FeedbackMessage"
Found = dict[str, list[str]]


def actions(known: Snapshot) -> Found:
    """Names and types of all that a server offers or a client waits for."""
    return _found(known.endpoints)


def action_servers_of(known: Snapshot, node: str) -> Found:
    return _found(end for end in known.endpoints if end.full_node == node and end.writes)


def action_clients_of(known: Snapshot, node: str) -> Found:
    return _found(end for end in known.endpoints if end.full_node == node and not end.writes)


def nodes_with(known: Snapshot, action: str, *, servers: bool) -> list[tuple[str, list[str]]]:
    """Each node that serves the action, or that uses it, with its types."""
    found = action_servers_of if servers else action_clients_of
    pairs = ((node, found(known, node).get(action)) for node in dict.fromkeys(known.nodes))
    return [(node, types) for node, types in pairs if types]


def _found(endpoints: Iterable[Endpoint]) -> Found:
    found: dict[str, set[str]] = {}
    for end in endpoints:
        if end.kind == "topic" and end.name.endswith(_FEEDBACK):
            found.setdefault(end.name.removesuffix(_FEEDBACK), set()).add(end.type.removesuffix(_TYPE_END))
    return {name: sorted(types) for name, types in sorted(found.items())}

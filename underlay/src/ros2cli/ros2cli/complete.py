"""What the Tab key offers: names from the graph."""

from __future__ import annotations

from argparse import Namespace
from typing import Any

from ros2cli.graph import graph
from ros2cli.snapshot import is_hidden


def node_names(prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
    return [node for node in graph(parsed_args).nodes if not is_hidden(node)]


def topic_names(prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
    return list(graph(parsed_args).topics(hidden=_wants_hidden(parsed_args, "topics")))


def topic_types(prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
    return graph(parsed_args).topics(hidden=True).get(str(parsed_args.topic_name), [])


def all_topic_types(prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
    return sorted({kind for kinds in graph(parsed_args).topics(hidden=True).values() for kind in kinds})


def service_names(prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
    return list(graph(parsed_args).services(hidden=_wants_hidden(parsed_args, "services")))


def service_types(prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
    return graph(parsed_args).services(hidden=True).get(str(parsed_args.service_name), [])


def action_names(prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
    from ros2cli.actions import actions

    return list(actions(graph(parsed_args)))


def action_types(prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
    from ros2cli.actions import actions

    return actions(graph(parsed_args)).get(str(parsed_args.action_name), [])


def _wants_hidden(args: Namespace, what: str) -> bool:
    return bool(getattr(args, f"include_hidden_{what}", False))

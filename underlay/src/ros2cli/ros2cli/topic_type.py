"""Of what type a topic is, from the graph."""

from __future__ import annotations

from typing import Any

from ros2cli.discovery import discover
from ros2cli.errors import CommandError
from ros2cli.node import handle_of, wait_until


def full_topic_name(node: Any, name: str) -> str:
    """With the namespace; CommandError for what cannot be a topic's name."""
    from rclpy.exceptions import InvalidTopicNameException
    from rclpy.expand_topic_name import expand_topic_name
    from rclpy.validate_full_topic_name import validate_full_topic_name

    try:
        full: str = expand_topic_name(name, node.get_name(), node.get_namespace())
        validate_full_topic_name(full)
    except (InvalidTopicNameException, ValueError) as error:
        raise CommandError(f"topic name '{name}' is invalid: {_reason(error)}") from error
    return full


def message_class(name: str) -> Any:
    """The Python class of a message type; package/Name is enough."""
    from rosidl_runtime_py.utilities import get_message

    try:
        return get_message(name)
    except (AttributeError, ModuleNotFoundError, ValueError) as error:
        raise CommandError("The passed message type is invalid") from error


def class_of_topic(node: Any, name: str, patience: float | None, *, block: bool) -> Any:
    """Of the topic's messages. A topic that nobody has is waited for, if told to; else it is None."""
    found = _types(node, name)
    if not found:
        discover(handle_of(node), patience, enough=lambda: bool(_types(node, name)))
        found = _types(node, name)
    if not found:
        print(f"WARNING: topic [{name}] does not appear to be published yet")
        if not block:
            return None
        wait_until(lambda: not node.context.ok() or _types(node, name))
        found = _types(node, name) if node.context.ok() else []
    return _class(name, found)


def _class(topic: str, types: list[str]) -> Any:
    if len(types) > 1:
        raise CommandError(
            f"Cannot echo topic '{topic}', as it contains more than one type: [{', '.join(types)}]"
        )
    try:
        from rosidl_runtime_py.utilities import get_message

        return get_message(types[0]) if types else None
    except (AttributeError, ModuleNotFoundError, ValueError) as error:
        raise CommandError(f"The message type '{types[0]}' is invalid") from error


def _types(node: Any, name: str) -> list[str]:
    return sorted(
        {kind for topic, kinds in node.get_topic_names_and_types() if topic == name for kind in kinds}
    )


def _reason(error: Exception) -> str:
    return str(error).splitlines()[0].split(": ", 1)[-1].partition(", at ")[0].rstrip(":")

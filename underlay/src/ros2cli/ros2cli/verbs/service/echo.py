"""`ros2 service echo`: what goes to and from a service whose introspection is on."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from typing import Any

from ros2cli.arguments import add_completed
from ros2cli.complete import service_names, service_types
from ros2cli.errors import CommandError
from ros2cli.form_arguments import add_form_arguments, limits

_EVENTS = "/_service_event"
_SILENT = (
    "WARNING: service [{name}] does not publish what goes on: "
    "introspection is off in its server and its clients"
)


def add_arguments(parser: ArgumentParser) -> None:
    text = "Name of the ROS service to echo (e.g. '/add_two_ints')"
    add_completed(parser, "service_name", service_names, help=text)
    text = "Type of the ROS service (e.g. 'example_interfaces/srv/AddTwoInts')"
    add_completed(parser, "service_type", service_types, nargs="?", help=text)
    add_form_arguments(parser)


def main(args: Namespace) -> int | str | None:
    from ros2cli.discovery import discover
    from ros2cli.node import handle_of, own_node
    from ros2cli.topic_type import full_topic_name

    with own_node() as node:
        name = full_topic_name(node, args.service_name)
        known = discover(handle_of(node))
        kind = _event_class(name, args.service_type, known.services(hidden=True).get(name, []))
        if kind is None:
            return "Could not determine the type for the passed service"
        if not known.publishers(name + _EVENTS):
            print(_SILENT.format(name=name), file=sys.stderr)
        return _listen(args, node, name + _EVENTS, kind)


def _event_class(name: str, asked: str | None, found: list[str]) -> Any:
    """The message that tells of a request or a response; None for a service that nobody has."""
    from rosidl_runtime_py.utilities import get_service

    if asked is None and len(found) > 1:
        types = ", ".join(found)
        raise CommandError(f"Cannot echo service '{name}', as it contains more than one type: [{types}]")
    if asked is None and not found:
        return None
    try:
        return get_service(asked or found[0]).Event
    except (AttributeError, ModuleNotFoundError, ValueError) as error:
        raise CommandError(f"The service type '{asked or found[0]}' is invalid") from error


def _listen(args: Namespace, node: Any, topic: str, kind: Any) -> int:
    from rclpy.qos import QoSProfile

    from ros2cli.echo_qos import DEPTH, fitting
    from ros2cli.listening import listen

    def show(event: Any, info: Any) -> None:
        print(_line(event, args) if args.csv else f"{_yaml(event, args)}---")

    qos = fitting(node, topic, QoSProfile(depth=DEPTH))
    return listen(node, node.create_subscription(kind, topic, lambda _: None, qos), show)


def _line(event: Any, args: Namespace) -> str:
    from rosidl_runtime_py import message_to_csv

    return str(message_to_csv(event, **limits(args)))


def _yaml(event: Any, args: Namespace) -> str:
    """With a word instead of the event's number."""
    from rosidl_runtime_py import message_to_yaml

    text = str(message_to_yaml(event, **limits(args), flow_style=args.flow_style))
    number = event.info.event_type
    return text.replace(f"  event_type: {number}\n", f"  event_type: {_word(event.info)}\n", 1)


def _word(info: Any) -> str:
    names = "REQUEST_SENT REQUEST_RECEIVED RESPONSE_SENT RESPONSE_RECEIVED".split()
    return {getattr(type(info), name): name for name in names}.get(info.event_type, str(info.event_type))

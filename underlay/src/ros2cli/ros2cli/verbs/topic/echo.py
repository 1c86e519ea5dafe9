"""`ros2 topic echo`."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from typing import Any

from ros2cli.arguments import add_completed, positive_float
from ros2cli.complete import topic_names, topic_types
from ros2cli.form_arguments import add_form_arguments
from ros2cli.graph import add_graph_arguments
from ros2cli.qos_options import add_qos_arguments


def add_arguments(parser: ArgumentParser) -> None:
    add_graph_arguments(parser)
    add_qos_arguments(parser, "subscribe", "sensor_data")
    add_form_arguments(parser, with_field=True)
    parser.add_argument("--no-lost-messages", action="store_true", help="Don't report when a message is lost")
    parser.add_argument("--raw", action="store_true", help="Echo the raw binary representation")
    parser.add_argument(
        "--filter",
        dest="filter_expr",
        help="Print only messages of which this Python expression is true; it calls the message m.",
    )
    parser.add_argument("--once", action="store_true", help="Print the first message received and then exit.")
    parser.add_argument(
        "--timeout", metavar="N", type=positive_float, help="Set a timeout in seconds to wait"
    )
    parser.add_argument(
        "--include-message-info", "-i", action="store_true", help="Shows the associated message info."
    )
    add_completed(
        parser, "topic_name", topic_names, help="Name of the ROS topic to listen to (e.g. '/chatter')"
    )
    add_completed(
        parser,
        "message_type",
        topic_types,
        nargs="?",
        help="Type of the ROS message (e.g. 'std_msgs/msg/String')",
    )


def main(args: Namespace) -> int | str | None:
    from ros2cli.echo_form import Form
    from ros2cli.node import own_node
    from ros2cli.topic_type import class_of_topic, full_topic_name, message_class

    form = Form(args)
    with own_node(args) as node:
        name = full_topic_name(node, args.topic_name)
        if args.message_type is None:
            kind = class_of_topic(node, name, args.spin_time, block=False)
        else:
            kind = message_class(args.message_type)
        if kind is None:
            return "Could not determine the type for the passed topic"
        return _listen(args, node, name, kind, form)


def _listen(args: Namespace, node: Any, name: str, kind: Any, form: Any) -> int:
    from rclpy.event_handler import SubscriptionEventCallbacks

    from ros2cli.echo_qos import qos_for
    from ros2cli.listening import Stop, listen

    def show(message: Any, info: Any) -> None:
        if form.show(message, info) and args.once:
            raise Stop

    events = SubscriptionEventCallbacks(
        incompatible_qos=_report_incompatible, message_lost=None if args.no_lost_messages else _report_lost
    )
    qos = qos_for(args, node, name)
    subscription = node.create_subscription(
        kind, name, lambda _: None, qos, event_callbacks=events, raw=args.raw
    )
    return listen(node, subscription, show, timeout=args.timeout)


def _report_lost(event: Any) -> None:
    print(
        f"A message was lost!!!\n\ttotal count change:{event.total_count_change}\n"
        f"\ttotal count: {event.total_count}---"
    )


def _report_incompatible(event: Any) -> None:
    from rclpy.qos import qos_policy_name_from_kind

    policy = qos_policy_name_from_kind(event.last_policy_kind)
    print(
        "New publisher discovered on this topic, offering incompatible QoS. "
        "No messages will be received from it. "
        f"Last incompatible policy: {policy}",
        file=sys.stderr,
    )

"""What `hz`, `bw` and `delay` have in common: a subscription, and a report every second."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from typing import Any

from ros2cli.arguments import add_completed, positive_int
from ros2cli.complete import topic_names
from ros2cli.graph import add_direct_arguments

_REPORT_EVERY = 1.0
# Deep enough for what a fast topic sends while this process has no turn.
_DEPTH = 1000


def add_measuring_arguments(parser: ArgumentParser, topic: str, window: int, what: str) -> None:
    """`topic` is the name of the argument."""
    add_direct_arguments(parser)
    text = f"Name of the ROS topic to {what} (e.g. '/chatter')"
    add_completed(parser, topic, topic_names, help=text)
    text = f"window size, in # of messages, for calculating {what.split()[-1]} (default: {window})"
    parser.add_argument("-w", "--window", type=positive_int, default=window, metavar="WINDOW", help=text)


def measure(
    args: Namespace,
    topic: str,
    on_message: Callable[[Any, Any], None],
    report: Callable[[], None],
    *,
    raw: bool = True,
    on_start: Callable[[str], None] = lambda name: None,
) -> int:
    """Give every message and its times to `on_message`; with `raw`, its bytes."""
    from ros2cli.listening import listen
    from ros2cli.node import own_node
    from ros2cli.topic_type import class_of_topic, full_topic_name

    with own_node(args) as node:
        name = full_topic_name(node, topic)
        kind = class_of_topic(node, name, args.spin_time, block=True)
        if kind is None:  # told to end while nobody had the topic
            return 15
        subscription = node.create_subscription(kind, name, lambda _: None, _any_publisher(), raw=raw)
        on_start(name)
        return listen(node, subscription, on_message, every=(_REPORT_EVERY, report))


def _any_publisher() -> Any:
    from rclpy.qos import QoSProfile, ReliabilityPolicy

    return QoSProfile(depth=_DEPTH, reliability=ReliabilityPolicy.BEST_EFFORT)

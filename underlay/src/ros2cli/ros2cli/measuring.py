"""What `hz`, `bw` and `delay` have in common: a subscription, and a report every second."""

from __future__ import annotations

import time
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
    on_message: Callable[[Any, float], None],
    report: Callable[[float], None],
    *,
    raw: bool = True,
    on_start: Callable[[str], None] = lambda name: None,
) -> int:
    """Give every message and the second of its arrival to `on_message`; with `raw`, its bytes.

    `report` is called every second, with the second it is. Both are those of the machine's clock, when the
    middleware got the message; with `--use-sim-time` and without `--wall-time` those of /clock.
    """
    from ros2cli.listening import listen
    from ros2cli.node import own_node
    from ros2cli.sim_time import clock_of, seconds
    from ros2cli.topic_type import class_of_topic, full_topic_name

    with own_node(args) as node, clock_of(args, node) as clock:
        name = full_topic_name(node, topic)
        kind = class_of_topic(node, name, args.spin_time, block=True)
        if kind is None:  # told to end while nobody had the topic
            return 15
        is_simulated = args.use_sim_time and not getattr(args, "wall_time", False)

        def now() -> float:
            return seconds(clock) if is_simulated else time.time()

        def take(message: Any, info: dict[str, Any]) -> None:
            arrived = 0.0 if is_simulated else info.get("received_timestamp", 0) / 1e9
            moment = arrived or now()
            if moment > 0.0:  # simulation time has begun
                on_message(message, moment)

        subscription = node.create_subscription(kind, name, lambda _: None, _any_publisher(), raw=raw)
        on_start(name)
        return listen(node, subscription, take, every=(_REPORT_EVERY, lambda: report(now())))


def _any_publisher() -> Any:
    from rclpy.qos import QoSProfile, ReliabilityPolicy

    return QoSProfile(depth=_DEPTH, reliability=ReliabilityPolicy.BEST_EFFORT)

"""`ros2 topic pub`."""

from __future__ import annotations

import sys
import time
from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from typing import Any

from ros2cli.arguments import add_completed, non_negative_int, positive_float, positive_int
from ros2cli.complete import topic_names, topic_types
from ros2cli.errors import CommandError
from ros2cli.graph import add_direct_arguments
from ros2cli.qos_options import add_qos_arguments

_KEEP_ALIVE = 0.1
_LOOK_EVERY, _SAY_EVERY = 0.01, 1.0
_DELIVERED_WITHIN = 10.0  # a subscription that missed who publishes hears it again every 3 s


def add_arguments(parser: ArgumentParser) -> None:
    add_direct_arguments(parser)
    add_completed(
        parser, "topic_name", topic_names, help="Name of the ROS topic to publish to (e.g. '/chatter')"
    )
    add_completed(
        parser, "message_type", topic_types, help="Type of the ROS message (e.g. 'std_msgs/String')"
    )
    source = parser.add_mutually_exclusive_group()
    source.add_argument(
        "values",
        nargs="?",
        default="{}",
        help='Values of the message in YAML format (e.g. "data: Hello World"); default values when left out',
    )
    source.add_argument("--stdin", action="store_true", help="Read values from standard input")
    _add_amount_arguments(parser)
    add_qos_arguments(parser, "publish", "default")


def _add_amount_arguments(parser: ArgumentParser) -> None:
    add = parser.add_argument
    add(
        "-r",
        "--rate",
        metavar="N",
        type=positive_float,
        default=1.0,
        help="Publishing rate in Hz (default: 1)",
    )
    add(
        "-p",
        "--print",
        metavar="N",
        type=positive_int,
        default=1,
        help="Only print every N-th published message (default: 1)",
    )
    group = parser.add_mutually_exclusive_group()
    group.add_argument("-1", "--once", action="store_true", help="Publish one message and exit")
    group.add_argument(
        "-t", "--times", type=non_negative_int, default=0, help="Publish this number of times and then exit"
    )
    add(
        "-w",
        "--wait-matching-subscriptions",
        type=non_negative_int,
        default=None,
        help="Wait for this number of matching subscriptions (default: 1 with --once or --times, else 0)",
    )
    add(
        "--max-wait-time-secs",
        type=positive_float,
        default=None,
        help="Wait no longer than this for matching subscriptions (default: for ever)",
    )
    add(
        "--keep-alive",
        metavar="N",
        type=positive_float,
        default=_KEEP_ALIVE,
        help="Keep publishing node alive for N seconds after the last msg (default: 0.1)",
    )
    add("-n", "--node-name", help="Name of the created publishing node")


def main(args: Namespace) -> int | str | None:
    from ros2cli.node import own_node
    from ros2cli.qos_options import chosen_qos
    from ros2cli.topic_type import full_topic_name, message_class
    from ros2cli.values import fill, from_yaml

    kind = message_class(args.message_type)
    values = from_yaml(sys.stdin.read() if args.stdin else args.values)
    if not isinstance(values, dict):
        return "The passed value needs to be a dictionary in YAML format"
    message = kind()
    set_times = fill(message, values, at_publishing=True)
    with own_node(args, args.node_name or "") as node:
        name = full_topic_name(node, args.topic_name)
        publisher = node.create_publisher(kind, name, chosen_qos(args, "default", 10))
        return _publish(args, node, publisher, message, set_times)


def _publish(args: Namespace, node: Any, publisher: Any, message: Any, set_times: Any) -> int:
    from ros2cli.discovery import discover
    from ros2cli.node import handle_of
    from ros2cli.sim_time import clock_of

    times = 1 if args.once else args.times
    if args.spin_time is not None:
        discover(handle_of(node), args.spin_time, enough=lambda: publisher.get_subscription_count() > 0)
    _wait_for_subscriptions(args, node, publisher, times)
    if node.context.ok():
        print("publisher: beginning loop")
        with clock_of(args, node) as clock:
            _loop(args, node, publisher, message, set_times, times, clock)
    if times and node.context.ok():
        _hand_over(args, publisher)
    return 0 if node.context.ok() else 15


def _loop(
    args: Namespace, node: Any, publisher: Any, message: Any, set_times: Any, times: int, clock: Any
) -> None:
    from ros2cli.sim_time import seconds

    def now() -> float:
        return seconds(clock) if args.use_sim_time else time.monotonic()

    count, due = 0, now()
    while node.context.ok():
        count += 1
        set_times(clock.now().to_msg())
        if count % args.print == 0:
            print(f"publishing #{count}: {message!r}\n")
        publisher.publish(message)
        if count == times:
            return
        due = max(due + 1 / args.rate, now() - 1 / args.rate)
        _sleep_until(due, now, node)


def _sleep_until(due: float, now: Callable[[], float], node: Any) -> None:
    """In small steps: a signal to end does not wake a sleeper, and simulated time goes as it likes."""
    while (left := due - now()) > 0 and node.context.ok():
        time.sleep(min(left, 0.05))


def _wait_for_subscriptions(args: Namespace, node: Any, publisher: Any, times: int) -> None:
    wanted = args.wait_matching_subscriptions
    wanted = (1 if times else 0) if wanted is None else wanted
    start = said = time.monotonic()
    while node.context.ok() and publisher.get_subscription_count() < wanted:
        now = time.monotonic()
        is_first = said == start and now - start > _SAY_EVERY / 10
        if now - said >= _SAY_EVERY or is_first:
            print(f"Waiting for at least {wanted} matching subscription(s)...")
            said = now
        if args.max_wait_time_secs is not None and now - start > args.max_wait_time_secs:
            raise CommandError(_too_few(wanted, publisher.get_subscription_count()))
        time.sleep(_LOOK_EVERY)


def _too_few(wanted: int, found: int) -> str:
    return (
        f"Timed out waiting for subscribers: Expected {wanted} subscribers but only got {found} subscribers"
    )


def _hand_over(args: Namespace, publisher: Any) -> None:
    """Matched subscriptions must have received the last message before this process is gone."""
    from rclpy.duration import Duration

    publisher.wait_for_all_acked(Duration(seconds=_DELIVERED_WITHIN))
    time.sleep(args.keep_alive)

"""`ros2 doctor hello`: who is heard on a topic and by multicast, run on several machines at once."""

from __future__ import annotations

import socket
import sys
import time
from argparse import ArgumentParser, Namespace
from collections import Counter
from typing import Any

from ros2cli.arguments import positive_float, positive_int
from ros2cli.multicast import GROUP, PORT, join, limit_routers


def add_arguments(parser: ArgumentParser) -> None:
    add = parser.add_argument
    text = "Name of ROS topic to publish to (default: '/canyouhearme')"
    add("-t", "--topic", default="/canyouhearme", help=text)
    text = "Time period to publish/send one message (default: 0.1s)"
    add("-ep", "--emit-period", metavar="N", type=positive_float, default=0.1, help=text)
    text = "Time period to print summary table (default: 1.0s)"
    add("-pp", "--print-period", metavar="N", type=positive_float, default=1.0, help=text)
    text = "How many routers a multicast may pass (not set by default)"
    add("--ttl", type=positive_int, help=text)
    text = "Publish and send for one print period, print what was heard, and exit"
    add("-1", "--once", action="store_true", help=text)


def main(args: Namespace) -> int:
    from ros2cli.node import own_node
    from ros2cli.topic_type import full_topic_name

    with own_node() as node, _Multicast(args.ttl) as multicast:
        topic = _Topic(node, full_topic_name(node, args.topic))
        while node.context.ok():
            _emit(args, node, [topic, multicast])
            _print_summary(topic, multicast)
            if args.once:
                return 0
    return 15


def _emit(args: Namespace, node: Any, ways: list[Any]) -> None:
    """Say hello on every way again and again, for one print period."""
    import rclpy

    end = time.monotonic() + args.print_period
    while (now := time.monotonic()) < end and node.context.ok():
        for way in ways:
            way.send(f"hello, it's me {socket.gethostname()}")
        until = min(now + args.emit_period, end)
        while (left := until - time.monotonic()) > 0 and node.context.ok():
            rclpy.spin_once(node, timeout_sec=min(left, 0.05))
        ways[-1].receive()


def _print_summary(topic: _Topic, multicast: _Multicast) -> None:
    print("MULTIMACHINE COMMUNICATION SUMMARY")
    print(f"Topic: {topic.name}, Published Msg Count: {topic.sent}")
    _print_hosts("Subscribed from", topic.heard)
    print(f"Multicast Group/Port: {GROUP}/{PORT}, Sent Msg Count: {multicast.sent}")
    _print_hosts("Received from", multicast.heard)
    print("-" * 60)
    for way in (topic, multicast):
        way.sent, way.heard = 0, Counter()


def _print_hosts(title: str, heard: Counter[str]) -> None:
    print(f"{title}:")
    for host, count in sorted(heard.items()):
        print(f"    {host}: {count} msgs")
    if not heard:
        print("    nobody")


class _Topic:
    """Hello by way of ROS."""

    def __init__(self, node: Any, name: str) -> None:
        from std_msgs.msg import String

        self.name, self.sent, self.heard = name, 0, Counter[str]()
        self._kind = String
        self._publisher = node.create_publisher(String, name, 10)
        node.create_subscription(String, name, lambda message: self.heard.update([_host(message.data)]), 10)

    def send(self, text: str) -> None:
        self._publisher.publish(self._kind(data=text))
        self.sent += 1


class _Multicast:
    """Hello by way of UDP alone. Where the network has no multicast, that is said once."""

    def __init__(self, ttl: int | None) -> None:
        self.sent, self.heard = 0, Counter[str]()
        self._ttl = ttl
        self._has_failed = False

    def __enter__(self) -> _Multicast:
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.setblocking(False)
        try:
            join(self._socket, GROUP, PORT)
            if self._ttl is not None:
                limit_routers(self._socket, self._ttl)
        except OSError as error:
            self._complain(error)
        return self

    def __exit__(self, *exception: object) -> None:
        self._socket.close()

    def send(self, text: str) -> None:
        if self._has_failed:
            return
        try:
            self._socket.sendto(text.encode(), (GROUP, PORT))
        except OSError as error:
            self._complain(error)
        else:
            self.sent += 1

    def receive(self) -> None:
        """Take what has come since the last time."""
        while True:
            try:
                data = self._socket.recv(4096)
            except OSError:
                return
            self.heard.update([_host(data.decode(errors="replace"))])

    def _complain(self, error: OSError) -> None:
        if not self._has_failed:
            reason = error.strerror or error
            print(f"UserWarning: No multicast to {GROUP}/{PORT}: {reason}", file=sys.stderr)
        self._has_failed = True


def _host(text: str) -> str:
    return text.rpartition(" ")[2]

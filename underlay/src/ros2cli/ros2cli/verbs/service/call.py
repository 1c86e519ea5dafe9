"""`ros2 service call`."""

from __future__ import annotations

import sys
import time
from argparse import ArgumentParser, Namespace
from typing import Any

from ros2cli.arguments import add_completed, positive_float
from ros2cli.complete import service_names, service_types
from ros2cli.errors import CommandError

_LOOK_FIRST = 0.05


def add_arguments(parser: ArgumentParser) -> None:
    text = "Name of the ROS service to call to (e.g. '/add_two_ints')"
    add_completed(parser, "service_name", service_names, help=text)
    text = "Type of the ROS service (e.g. 'std_srvs/srv/Empty')"
    add_completed(parser, "service_type", service_types, help=text)
    source = parser.add_mutually_exclusive_group()
    text = 'Values of the request in YAML format (e.g. "{a: 1, b: 2}"); default values when left out'
    source.add_argument("values", nargs="?", default="{}", help=text)
    source.add_argument("--stdin", action="store_true", help="Read values from standard input")
    parser.add_argument(
        "-r", "--rate", metavar="N", type=positive_float, help="Repeat the call at a specific rate in Hz"
    )


def main(args: Namespace) -> int | str | None:
    from ros2cli.node import own_node
    from ros2cli.topic_type import full_topic_name
    from ros2cli.values import fill, from_yaml

    kind = _service_class(args.service_type)
    request = kind.Request()
    fill(request, from_yaml(sys.stdin.read() if args.stdin else args.values))
    with own_node() as node:
        client = node.create_client(kind, full_topic_name(node, args.service_name))
        return _call(args, node, client, request)


def _call(args: Namespace, node: Any, client: Any, request: Any) -> int | str | None:
    if not _is_there(node, client):
        return 15
    while True:
        started = time.monotonic()
        print(f"requester: making request: {request!r}\n")
        response = _answer(node, client, request)
        print(f"response:\n{response!r}\n")
        if args.rate is None:
            return None
        time.sleep(max(0.0, started + 1 / args.rate - time.monotonic()))


def _is_there(node: Any, client: Any) -> bool:
    """Wait for the service, saying so when that is not at once; False when the process is told to end."""
    from ros2cli.node import wait_until

    if not wait_until(client.service_is_ready, _LOOK_FIRST):
        print("waiting for service to become available...")
        wait_until(lambda: not node.context.ok() or client.service_is_ready())
    return bool(node.context.ok())


def _answer(node: Any, client: Any, request: Any) -> Any:
    import rclpy

    future = client.call_async(request)
    rclpy.spin_until_future_complete(node, future)
    if future.result() is None:
        raise RuntimeError(f"Exception while calling service: {future.exception()!r}")
    return future.result()


def _service_class(name: str) -> Any:
    from rosidl_runtime_py.utilities import get_service

    try:
        return get_service(name)
    except (AttributeError, ModuleNotFoundError, ValueError) as error:
        raise CommandError("The passed service type is invalid") from error

"""`ros2 multicast receive`."""

from __future__ import annotations

import contextlib
from argparse import ArgumentParser, Namespace

from ros2cli.multicast import add_group_arguments, join, udp


def add_arguments(parser: ArgumentParser) -> None:
    add_group_arguments(parser)


def main(args: Namespace) -> None:
    with contextlib.suppress(KeyboardInterrupt):  # the one way to stop waiting
        _receive(args)


def _receive(args: Namespace) -> None:
    print("Waiting for UDP multicast datagram...")
    with udp(args) as user:
        join(user, args.group, args.port)
        data, (host, port) = user.recvfrom(4096)
    print(f"Received from {host}:{port}: '{data.decode(errors='replace')}'")

"""`ros2 multicast send`."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from ros2cli.arguments import positive_int
from ros2cli.multicast import add_group_arguments, limit_routers, udp


def add_arguments(parser: ArgumentParser) -> None:
    add_group_arguments(parser)
    parser.add_argument("--ttl", type=positive_int, help="How many routers the datagram may pass")


def main(args: Namespace) -> None:
    print("Sending one UDP multicast datagram...")
    with udp(args) as user:
        if args.ttl is not None:
            limit_routers(user, args.ttl)
        user.sendto(b"Hello World!", (args.group, args.port))

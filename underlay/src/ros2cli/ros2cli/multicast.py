"""Where the verbs of `ros2 multicast` and `ros2 doctor hello` meet: a group of UDP, without any ROS."""

from __future__ import annotations

import contextlib
import socket
from argparse import ArgumentParser, Namespace
from collections.abc import Iterator

from ros2cli.arguments import positive_int
from ros2cli.errors import CommandError

GROUP, PORT = "225.0.0.1", 49150


def add_group_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("--group", default=GROUP, help="The multicast group address (default: %(default)s)")
    text = "The multicast port (default: %(default)s)"
    parser.add_argument("--port", type=positive_int, default=PORT, help=text)


def join(user: socket.socket, group: str, port: int) -> None:
    """Let the socket hear the group, also where other programs do."""
    user.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    user.bind(("", port))
    everywhere = socket.inet_aton(group) + socket.inet_aton("0.0.0.0")
    user.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, everywhere)


def limit_routers(user: socket.socket, ttl: int) -> None:
    """How many routers a datagram of the socket may pass."""
    user.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, min(ttl, 255))


@contextlib.contextmanager
def udp(args: Namespace) -> Iterator[socket.socket]:
    """A socket for the group of the command line. What the network refuses ends the command in one line."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as user:
        try:
            yield user
        except (OSError, OverflowError) as error:
            reason = getattr(error, "strerror", None) or error
            raise CommandError(f"No multicast to {args.group}:{args.port}: {reason}") from error

"""The daemon from outside: a process in the background that knows the graph already and tells it at once.

It listens on an abstract socket, which belongs to the network namespace as the graph itself does. There is
one for each user, ROS domain and kind of discovery.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import socket
import struct
import subprocess
import sys
import time
from typing import Any

from ros2cli.rcl import domain_id

_MATTERS = (
    "FASTDDS_BUILTIN_TRANSPORTS",
    "FASTRTPS_DEFAULT_PROFILES_FILE",
    "RMW_IMPLEMENTATION",
    "ROS_AUTOMATIC_DISCOVERY_RANGE",
    "ROS_DISCOVERY_SERVER",
    "ROS_LOCALHOST_ONLY",
    "ROS_STATIC_PEERS",
)
_ANSWER_WITHIN = 5.0
_START_WITHIN, _LOOK_EVERY = 10.0, 0.02


def address() -> str:
    """The name of the socket, of those processes that would see the same graph."""
    settings = json.dumps([sys.prefix, *(os.environ.get(name, "") for name in _MATTERS)])
    kind = hashlib.sha256(settings.encode()).hexdigest()[:12]
    return f"\0ros2course-ros2cli-{os.getuid()}-{domain_id()}-{kind}"


def ask(question: str) -> Any:
    """What the daemon says to `graph`, `status` or `stop`; None when there is no daemon to say it."""
    with contextlib.suppress(OSError, ValueError), socket.socket(socket.AF_UNIX) as connection:
        connection.settimeout(_ANSWER_WITHIN)
        connection.connect(address())
        if not is_ours(connection):
            return None
        connection.sendall(question.encode())
        connection.shutdown(socket.SHUT_WR)
        return json.loads(b"".join(iter(lambda: connection.recv(1 << 16), b"")))
    return None


def is_ours(connection: socket.socket) -> bool:
    """Whether the process at the other end is this user's: anyone may use such a name."""
    size = struct.calcsize("3i")
    credentials = connection.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, size)
    user: int = struct.unpack("3i", credentials)[1]
    return user == os.getuid()


def is_running() -> bool:
    return ask("status") is not None


def spawn() -> None:
    """Start the daemon in the background, if its code can be started at all; a second one ends by itself."""
    nothing = subprocess.DEVNULL
    subprocess.Popen(
        [sys.executable, "-m", "ros2cli.daemon_server"],
        stdin=nothing, stdout=nothing, stderr=nothing, cwd="/", start_new_session=True,
    )  # fmt: skip


def start() -> bool:
    """Start it and wait for its first word."""
    spawn()
    return _becomes(True)


def stop() -> bool:
    ask("stop")
    return _becomes(False)


def _becomes(running: bool) -> bool:
    end = time.monotonic() + _START_WITHIN
    while time.monotonic() < end:
        if is_running() == running:
            return True
        time.sleep(_LOOK_EVERY)
    return False

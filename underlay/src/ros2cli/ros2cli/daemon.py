"""The daemon from outside: a process in the background that knows the graph already and tells it at once.

It listens on an abstract socket, which belongs to the network namespace as the graph itself does. There is
one for each user and ROS domain. It answers who has the same ROS and network as itself (`identity.py`), and
ends when anyone else asks. Nothing that is wrong with it keeps a command from its work.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import socket
import struct
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from ros2cli.identity import identity
from ros2cli.rcl import domain_id

MODULE = "ros2cli.daemon_server"
# Its first byte comes at once; what it does not answer in time is found out without it.
_FIRST_WORD_WITHIN, _ANSWER_WITHIN = 1.0, 1.8
_START_WITHIN, _LOOK_EVERY = 10.0, 0.02


def is_allowed() -> bool:
    """Whether one may be used: nothing may outlive the grading of an exercise."""
    return os.environ.get("ROS2COURSE_ARENA") != "1"


def address() -> str:
    """The name of the socket."""
    return f"\0ros2course-ros2cli-{os.getuid()}-{domain_id()}"


def ask(question: str) -> Any:
    """What the daemon says to `graph`, `status` or `stop`; None when there is none that says it in time."""
    with contextlib.suppress(OSError, ValueError), socket.socket(socket.AF_UNIX) as connection:
        connection.settimeout(_FIRST_WORD_WITHIN)
        connection.connect(address())
        if not is_ours(connection):
            return None
        connection.sendall(json.dumps([question, identity()]).encode())
        connection.shutdown(socket.SHUT_WR)
        return json.loads(_first_word(connection) + _rest(connection))
    return None


def is_ours(connection: socket.socket) -> bool:
    """Whether the process at the other end is this user's: anyone may use such a name."""
    return _peer(connection)[1] == os.getuid()


def is_running() -> bool:
    return ask("status") is not None


def spawn() -> None:
    """Start the daemon in the background; a second one ends by itself.

    It keeps nothing of the caller: no stream, no folder, no terminal, and so it gets no Ctrl+C.
    """
    nothing = subprocess.DEVNULL
    with contextlib.suppress(OSError):
        subprocess.Popen(
            [sys.executable, "-m", MODULE],
            stdin=nothing, stdout=nothing, stderr=nothing, cwd="/", start_new_session=True,
        )  # fmt: skip


def start(say: Callable[[str], None] = lambda text: None) -> bool:
    """Start it and wait for its first word."""
    began = time.monotonic()
    say(f"Starting {sys.executable} -m {MODULE}, which listens on @{address()[1:]}")
    spawn()
    found = _becomes(True)
    say(f"{'It answered' if found else 'No answer'} after {time.monotonic() - began:.2f} s")
    return found


def stop() -> bool | None:
    """Whether it has ended; None when there was none."""
    return _becomes(False) if ask("stop") is not None else None


def _becomes(running: bool) -> bool:
    end = time.monotonic() + _START_WITHIN
    while time.monotonic() < end:
        if is_running() == running:
            return True
        time.sleep(_LOOK_EVERY)
    return False


def _first_word(connection: socket.socket) -> bytes:
    """The byte that says that it lives. One of ours that does not is in everyone's way."""
    try:
        return connection.recv(1)
    except TimeoutError:
        pid = _peer(connection)[0]
        if pid > 0 and MODULE.encode() in Path(f"/proc/{pid}/cmdline").read_bytes():
            os.kill(pid, signal.SIGKILL)
        raise


def _rest(connection: socket.socket) -> bytes:
    end, parts = time.monotonic() + _ANSWER_WITHIN - _FIRST_WORD_WITHIN, [b""]
    while len(parts) == 1 or parts[-1]:
        connection.settimeout(max(0.001, end - time.monotonic()))
        parts.append(connection.recv(1 << 16))
    return b"".join(parts)


def _peer(connection: socket.socket) -> tuple[int, int]:
    """Process and user at the other end; 0 for a process that cannot be seen from here."""
    size = struct.calcsize("3i")
    pid, user, _ = struct.unpack("3i", connection.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, size))
    return pid, user

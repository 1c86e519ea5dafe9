"""The daemon itself: `python -m ros2cli.daemon_server`."""

from __future__ import annotations

import contextlib
import json
import signal
import socket
import sys
import uuid
from typing import Any

from ros2cli.daemon import address, is_ours
from ros2cli.discovery import discover
from ros2cli.living import without_the_dead
from ros2cli.rcl import Handle, domain_id, quick_node
from ros2cli.snapshot import to_data

_IDLE = 2 * 60 * 60.0
_READ_WITHIN = 1.0


def main() -> None:
    """Answer until told to stop, or until nobody has asked for two hours."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(0))
    signal.signal(signal.SIGHUP, signal.SIG_IGN)
    with socket.socket(socket.AF_UNIX) as server, contextlib.suppress(OSError, KeyboardInterrupt):
        server.bind(address())  # refused when there is one already
        with quick_node(f"_ros2cli_daemon_{domain_id()}_{uuid.uuid4().hex}") as handle:
            server.listen()
            server.settimeout(_IDLE)
            while _serve_one(server, handle):
                pass


def _serve_one(server: socket.socket, handle: Handle) -> bool:
    """Answer one question; False when it was the last one."""
    connection, _ = server.accept()
    with connection, contextlib.suppress(OSError):
        connection.settimeout(_READ_WITHIN)
        if is_ours(connection):
            question = b"".join(iter(lambda: connection.recv(64), b"")).decode(errors="replace")
            if question == "stop":
                server.close()
            connection.sendall(json.dumps(_answer(question, handle)).encode())
            return question != "stop"
    return True


def _answer(question: str, handle: Handle) -> Any:
    if question == "graph":
        return to_data(without_the_dead(discover(handle), handle.name))
    return question


if __name__ == "__main__":
    main()

"""The daemon itself: `python -m ros2cli.daemon_server`."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import socket
import sys
import threading
import time
import uuid
from pathlib import Path
from typing import Any

from ros2cli.daemon import address, is_allowed, is_ours
from ros2cli.discovery import discover
from ros2cli.identity import identity
from ros2cli.living import without_the_dead
from ros2cli.rcl import Handle, domain_id, quick_node
from ros2cli.snapshot import to_data

_IDLE = 2 * 60 * 60.0
_LOOK_AROUND_EVERY = 10.0
_READ_WITHIN, _FINISH_WITHIN = 1.0, 3.0
_ALIVE = b" "  # no part of the answer


def main() -> None:
    """Answer until told to stop, until nobody has asked for two hours, or until nobody is left to ask."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(0))
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGHUP, signal.SIG_IGN)
    if not is_allowed():
        return
    with socket.socket(socket.AF_UNIX) as server, contextlib.suppress(OSError):
        server.bind(address())  # refused when there is one already
        with quick_node(f"_ros2cli_daemon_{domain_id()}_{uuid.uuid4().hex}") as handle:
            server.listen()
            _Daemon(server, handle).serve()


class _Daemon:
    """Answers every question in a thread of its own, so that none has to wait for its first byte."""

    def __init__(self, server: socket.socket, handle: Handle) -> None:
        self._server, self._handle = server, handle
        self._born_as = identity()
        self._ended = threading.Event()

    def serve(self) -> None:
        self._server.settimeout(_LOOK_AROUND_EVERY)
        try:
            self._serve()
        finally:
            for thread in threading.enumerate():
                if thread is not threading.current_thread():
                    thread.join(_FINISH_WITHIN)

    def _serve(self) -> None:
        asked = time.monotonic()
        while not self._ended.is_set() and time.monotonic() - asked < _IDLE:
            try:
                connection, _ = self._server.accept()
            except TimeoutError:
                if identity() != self._born_as or not has_company():
                    return
                continue
            asked = time.monotonic()
            threading.Thread(target=self._answer, args=[connection], daemon=True).start()

    def _answer(self, connection: socket.socket) -> None:
        with connection, contextlib.suppress(OSError, ValueError):
            connection.settimeout(_READ_WITHIN)
            if is_ours(connection):
                connection.sendall(_ALIVE)
                question, asked_by = json.loads(b"".join(iter(lambda: connection.recv(4096), b"")))
                connection.sendall(json.dumps(self._reply(question, asked_by)).encode())

    def _reply(self, question: str, asked_by: list[str]) -> Any:
        is_other = asked_by != self._born_as
        if question == "stop" or is_other:
            self._end()
        if question == "graph" and not is_other:
            return to_data(without_the_dead(discover(self._handle), self._handle.name))
        return None if is_other and question != "stop" else question

    def _end(self) -> None:
        """The name is free for the next one before who asked hears of it."""
        self._ended.set()
        with contextlib.suppress(OSError):
            self._server.shutdown(socket.SHUT_RDWR)
        self._server.close()


def has_company(processes: Path = Path("/proc")) -> bool:
    """Whether this user has another process in this network namespace, which could ask."""
    own = str((processes / "self/ns/net").readlink())
    others = (
        entry for entry in processes.iterdir() if entry.name.isdigit() and int(entry.name) != os.getpid()
    )
    return any(_has_link(entry / "ns/net", own) for entry in others)


def _has_link(link: Path, target: str) -> bool:
    try:
        return str(link.readlink()) == target
    except OSError:  # another user's, or gone
        return False


if __name__ == "__main__":
    main()

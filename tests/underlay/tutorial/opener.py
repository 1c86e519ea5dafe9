"""Runs in namespaces of its own and opens terminals there: `python opener.py FD`.

Each request on the socket FD is a JSON object, {"command": [...], "environment": {...}, "cwd": ...,
"rows": ..., "columns": ...}; the answer is the other end of its pseudo-terminal, as a file descriptor.
"""

from __future__ import annotations

import fcntl
import json
import os
import pty
import signal
import socket
import struct
import sys
import termios
from typing import Any


def main(descriptor: int) -> None:
    signal.signal(signal.SIGCHLD, lambda *_: _bury())
    link = socket.socket(fileno=descriptor)
    while asked := link.recv(1 << 16):
        terminal = _opened(json.loads(asked))
        socket.send_fds(link, [b"opened"], [terminal])
        os.close(terminal)


def _opened(request: dict[str, Any]) -> int:
    command = request["command"]
    # What begins before the size is known would see a terminal of no size.
    begin_read, begin_write = os.pipe()
    pid, terminal = pty.fork()
    if pid == 0:
        signal.signal(signal.SIGCHLD, signal.SIG_DFL)
        os.close(begin_write)
        os.read(begin_read, 1)
        os.chdir(request["cwd"])
        os.execve(command[0], command, request["environment"])
    fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", request["rows"], request["columns"], 0, 0))
    os.close(begin_write)
    os.close(begin_read)
    return terminal


def _bury() -> None:
    try:
        while os.waitpid(-1, os.WNOHANG) != (0, 0):
            pass
    except ChildProcessError:
        pass


if __name__ == "__main__":
    main(int(sys.argv[1]))

"""A pseudo-terminal as the output of a process that is to believe in one."""

from __future__ import annotations

import asyncio
import contextlib
import os
import pty

from launch.child.protocol import ChildProtocol


class Terminal:
    """One stream: the process writes to `slave`, what it wrote is handed to the protocol as `fd`'s."""

    def __init__(self, fd: int, protocol: ChildProtocol) -> None:
        self._fd = fd
        self._protocol = protocol
        self._master, self.slave = pty.openpty()

    def listen(self) -> None:
        """The process has its end: ours is closed, so that its end ends the stream."""
        os.close(self.slave)
        asyncio.get_running_loop().add_reader(self._master, self._read)

    def _read(self) -> None:
        data = b""
        with contextlib.suppress(OSError):  # EIO: nobody has the other end
            data = os.read(self._master, 65536)
        if data:
            self._protocol.pipe_data_received(self._fd, data)
        else:
            self.close()
            self._protocol.stream_ended()

    def close(self) -> None:
        if self._master >= 0:
            asyncio.get_running_loop().remove_reader(self._master)
            os.close(self._master)
            self._master = -1

"""What asyncio tells of a process."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

OnOutput = Callable[[int, bytes], None]


class ChildProtocol(asyncio.SubprocessProtocol):
    """Keeps output until someone listens; `exited` and `silent` (no pipe open any more) can be awaited."""

    def __init__(self, streams: int) -> None:
        self._early: list[tuple[int, bytes]] = []
        self._on_output: OnOutput | None = None
        self._open = streams
        self.exited = asyncio.Event()
        self.silent = asyncio.Event()

    def listen(self, on_output: OnOutput) -> None:
        self._on_output = on_output
        for fd, data in self._early:
            on_output(fd, data)
        self._early.clear()

    def pipe_data_received(self, fd: int, data: bytes) -> None:
        if self._on_output is None:
            self._early.append((fd, data))
        else:
            self._on_output(fd, data)

    def pipe_connection_lost(self, fd: int, exc: Exception | None) -> None:
        if fd != 0:
            self.stream_ended()

    def stream_ended(self) -> None:
        self._open -= 1
        if self._open <= 0:
            self.silent.set()

    def process_exited(self) -> None:
        self.exited.set()

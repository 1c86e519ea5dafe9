"""Where the output of one process goes."""

from __future__ import annotations

from collections.abc import Callable
from logging import Logger

from launch.child.lines import Lines


class Output:
    """Two streams, line by line to their loggers; with `cached` only when the process has ended."""

    def __init__(self, loggers: tuple[Logger, Logger], form: Callable[[str], str], cached: bool) -> None:
        self._loggers = dict(zip((1, 2), loggers, strict=True))
        self._lines = {1: Lines(), 2: Lines()}
        self._form = form
        self._cached = cached
        self._waiting: list[tuple[int, list[str]]] = []
        self.collected = {1: bytearray(), 2: bytearray()}

    def take(self, fd: int, data: bytes) -> None:
        if self._cached:
            self.collected[fd] += data
        self._pass_on(fd, self._lines[fd].feed(data))

    def finish(self) -> None:
        """Shows what has no end of line, and all that was held back."""
        for fd, lines in self._lines.items():
            self._pass_on(fd, lines.rest())
        for fd, held in self._waiting:
            self._show(fd, held)
        self._waiting.clear()

    def _pass_on(self, fd: int, lines: list[str]) -> None:
        if self._cached:
            self._waiting.append((fd, lines))
        else:
            self._show(fd, lines)

    def _show(self, fd: int, lines: list[str]) -> None:
        """All at once: a process that floods its output leaves time for everything else."""
        if lines:
            self._loggers[fd].info("%s", "\n".join(map(self._form, lines)))

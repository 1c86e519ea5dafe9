"""The screen: standard output, one line at a time."""

from __future__ import annotations

import logging
import os
import sys
from collections.abc import Callable


class ScreenHandler(logging.Handler):
    """Writes to what `sys.stdout` is at the time. A closed pipe ends the launch, not in a traceback."""

    on_closed: list[Callable[[], None]] = []  # noqa: RUF012  those who want to know: the launch service

    def emit(self, record: logging.LogRecord) -> None:
        try:
            sys.stdout.write(self.format(record) + "\n")
            sys.stdout.flush()
        except BrokenPipeError:
            self._give_up()
        except (OSError, ValueError):
            self.handleError(record)

    def _give_up(self) -> None:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        for tell in tuple(self.on_closed):
            tell()

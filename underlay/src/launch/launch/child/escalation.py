"""SIGINT was not enough: SIGTERM, then SIGKILL."""

from __future__ import annotations

import asyncio
import signal
from collections.abc import Callable
from logging import Logger


class Escalation:
    """Timers from a shutdown on, until the process has ended."""

    def __init__(self, name: str, logger: Logger, send: Callable[[signal.Signals], None]) -> None:
        self._name = name
        self._logger = logger
        self._send = send
        self._timers: list[asyncio.TimerHandle] = []

    def begin(self, sigterm_timeout: str, sigkill_timeout: str) -> None:
        loop = asyncio.get_running_loop()
        first = float(sigterm_timeout)
        second = first + float(sigkill_timeout)
        self._timers = [
            loop.call_later(first, self._raise_to, sigterm_timeout, "SIGINT", signal.SIGTERM),
            loop.call_later(second, self._raise_to, str(second), "SIGTERM", signal.SIGKILL),
        ]

    def cancel(self) -> None:
        for timer in self._timers:
            timer.cancel()

    def _raise_to(self, seconds: str, before: str, number: signal.Signals) -> None:
        self._logger.error(
            f"process[{self._name}] failed to terminate '{seconds}' seconds after receiving '{before}', "
            f"escalating to '{number.name}'"
        )
        self._send(number)

"""Signals to the launch itself: all of them end what was launched first."""

from __future__ import annotations

import asyncio
import contextlib
import signal
from collections.abc import Iterator
from typing import TYPE_CHECKING

from launch.logging import get_logger

if TYPE_CHECKING:
    from launch.launch_service import LaunchService

_ENDING = (signal.SIGTERM, signal.SIGQUIT, signal.SIGHUP)


class Interruptions:
    """What arrived, and what it leads to."""

    def __init__(self, service: LaunchService) -> None:
        self._service = service
        self._interrupted = False
        self.ended_by: int | None = None

    @contextlib.contextmanager
    def handled(self) -> Iterator[None]:
        """Handlers are in place within; elsewhere than in the main thread there can be none."""
        loop = asyncio.get_running_loop()
        try:
            self._install(loop)
        except (ValueError, RuntimeError):  # not the main thread
            yield
            return
        try:
            yield
        finally:
            for number in (signal.SIGINT, *_ENDING):
                loop.remove_signal_handler(number)

    def _install(self, loop: asyncio.AbstractEventLoop) -> None:
        loop.add_signal_handler(signal.SIGINT, self._on_interrupt)
        for number in _ENDING:
            # What is ignored on purpose, as by nohup, stays so.
            if signal.getsignal(number) is not signal.SIG_IGN:
                loop.add_signal_handler(number, self._on_end, number)

    def _on_interrupt(self) -> None:
        told = "user interrupted with ctrl-c (SIGINT)"
        get_logger("launch").warning(told + (" again, ignoring..." if self._interrupted else ""))
        if not self._interrupted:
            self._interrupted = True
            self._service.end("ctrl-c (SIGINT)", due_to_sigint=True)

    def _on_end(self, number: int) -> None:
        if self.ended_by is not None:
            return
        self.ended_by = number
        name = signal.Signals(number).name
        get_logger("launch").warning(f"told to end ({name}), shutting down")
        self._service.end(name)

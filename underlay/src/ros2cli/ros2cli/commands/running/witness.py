"""Tells signals that the whole process group got from those that only this process got.

Nothing in a signal says so. A second process of the same group does: it waits for signals and reports each
one. What it has not reported after a moment was meant for us alone.
"""

from __future__ import annotations

import os
import select
import signal
from typing import NoReturn

from ros2cli.commands.running.bound import binding

_PATIENCE = 0.2  # seconds; the members of a group get a signal within microseconds of each other


class Witness:
    """A process beside this one that sees what the group gets, for as long as the `with` block lasts."""

    def __init__(self, watched: frozenset[signal.Signals]) -> None:
        self._watched = watched

    def __enter__(self) -> Witness:
        bind = binding()
        self._reports, writing = os.pipe()
        before = signal.pthread_sigmask(signal.SIG_BLOCK, self._watched)
        self._pid = os.fork()
        if self._pid == 0:
            bind()
            _report_signals(self._watched, writing)
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
        os.close(writing)
        return self

    def __exit__(self, *exception: object) -> None:
        os.kill(self._pid, signal.SIGKILL)
        os.waitpid(self._pid, 0)
        os.close(self._reports)

    def saw(self, number: int) -> bool:
        """Tell whether the process group got this signal, too."""
        while select.select([self._reports], [], [], _PATIENCE)[0]:
            report = os.read(self._reports, 1)
            if not report or report[0] == number:
                return bool(report)
        return False


def _report_signals(watched: frozenset[signal.Signals], writing: int) -> NoReturn:
    while True:
        os.write(writing, bytes([signal.sigwait(watched)]))

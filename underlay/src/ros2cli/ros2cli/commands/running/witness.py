"""Tells signals that the whole process group got from those that only this process got.

Nothing in a signal says so. A second process of the same group does: it waits for signals and reports each
one. What it has not reported after a moment, nor when it is asked, was meant for us alone.
"""

from __future__ import annotations

import os
import select
import signal
from collections.abc import Iterator
from itertools import takewhile
from typing import NoReturn

from ros2cli.commands.running.bound import binding

_PATIENCE = 0.2  # seconds; the members of a group get a signal within microseconds of each other
# The question whether anything is left to report, and the answer that there is not. The kernel hands over
# waiting signals in the order of their numbers, and so this one after all that can be watched.
_QUESTION = signal.SIGRTMIN
_ANSWERED_WITHIN = 5.0  # seconds; on a machine with too much to do the witness may have to wait for its turn


class Witness:
    """A process beside this one that sees what the group gets, for as long as the `with` block lasts."""

    def __init__(self, watched: frozenset[signal.Signals]) -> None:
        self._watched = watched

    def __enter__(self) -> Witness:
        bind = binding()
        self._reports, writing = os.pipe()
        os.set_blocking(self._reports, False)
        reported = {*self._watched, _QUESTION}
        before = signal.pthread_sigmask(signal.SIG_BLOCK, reported)
        self._pid = os.fork()
        if self._pid == 0:
            bind()
            _report_signals(reported, writing)
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
        os.close(writing)
        return self

    def __exit__(self, *exception: object) -> None:
        os.kill(self._pid, signal.SIGKILL)
        os.waitpid(self._pid, 0)
        os.close(self._reports)

    def saw(self, number: int) -> bool:
        """Tell whether the process group got this signal, too."""
        return number in self._heard(_PATIENCE) or self._has_seen(number)

    def _has_seen(self, number: int) -> bool:
        """What it says when it is asked: it may not have had the time to report by itself."""
        os.kill(self._pid, _QUESTION)
        # All up to the answer: it must not be taken for that to a later question.
        return number in list(takewhile(lambda report: report != _QUESTION, self._heard(_ANSWERED_WITHIN)))

    def _heard(self, patience: float) -> Iterator[int]:
        """Its reports, until it is silent for so long."""
        while select.select([self._reports], [], [], patience)[0]:
            try:
                report = os.read(self._reports, 1)
            except BlockingIOError:  # the handler of a second signal, in the midst of this, has taken it
                continue
            if not report:
                return
            yield report[0]


def _report_signals(watched: set[int], writing: int) -> NoReturn:
    while True:
        os.write(writing, bytes([signal.sigwait(watched)]))

"""Stopping a command in order, with everything it started."""

from __future__ import annotations

import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import NoReturn

_LIKE_INTERRUPT = (signal.SIGTERM, signal.SIGHUP)


@contextmanager
def ended_cleanly() -> Iterator[Callable[[], None]]:
    """Inside this context, a closed terminal or a `kill` ends the command like Ctrl+C, with all it started.

    Yields a function for a long loop to call now and then. It raises again if a signal came and its
    exception was lost: Python only prints what is raised while an object is being destroyed.
    """
    came: list[int] = []

    def leave(number: int, _frame: FrameType | None) -> NoReturn:
        came.append(number)
        _raise(number)

    def again() -> None:
        if came:
            _raise(came[0])

    # A program that was started in the background ignores Ctrl+C, and must continue to do so.
    ctrl_c = (signal.SIGINT,) if signal.getsignal(signal.SIGINT) is signal.default_int_handler else ()
    before = {number: signal.signal(number, leave) for number in (*ctrl_c, *_LIKE_INTERRUPT)}
    try:
        yield again
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _raise(number: int) -> NoReturn:
    if number == signal.SIGINT:
        raise KeyboardInterrupt
    sys.exit(128 + number)

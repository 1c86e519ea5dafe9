"""Stopping a command in order, with everything it started."""

from __future__ import annotations

import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import NoReturn


@contextmanager
def ended_cleanly() -> Iterator[None]:
    """A closed terminal or a `kill` ends what goes on like Ctrl+C does, with everything it started."""
    signals = (signal.SIGTERM, signal.SIGHUP)
    before = {number: signal.signal(number, _leave) for number in signals}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _leave(number: int, _frame: object) -> NoReturn:
    sys.exit(128 + number)

"""How late this process gets the CPU: what a machine with too much to do takes from every measurement."""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Iterator

_PERIOD = 0.02


class Lag:
    """worst: seconds between the moment a waiting thread wanted to go on, and the moment it did."""

    def __init__(self) -> None:
        self.worst = 0.0


@contextlib.contextmanager
def measured_lag() -> Iterator[Lag]:
    """Measure in a thread of its own until the end."""
    lag, over = Lag(), threading.Event()

    def watch() -> None:
        wanted = time.monotonic() + _PERIOD
        while not over.wait(_PERIOD):
            now = time.monotonic()
            lag.worst = max(lag.worst, now - wanted)
            wanted = now + _PERIOD

    thread = threading.Thread(target=watch, name="lag", daemon=True)
    thread.start()
    try:
        yield lag
    finally:
        over.set()
        thread.join()

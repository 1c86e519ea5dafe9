"""Threads for builds, which Ctrl+C in the main thread calls off."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

from course.build import Interrupt


@contextlib.contextmanager
def workers() -> Iterator[tuple[ThreadPoolExecutor, Interrupt]]:
    """Threads for builds, which are called off when this one is interrupted."""
    with Interrupt() as stop, ThreadPoolExecutor(2, "check") as pool:
        try:
            yield pool, stop
        except BaseException:
            stop.set()
            raise

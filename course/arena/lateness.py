"""Notes how late this machine lets a thread of ours go on, for those who judge milliseconds."""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Iterator

from course.evidence.events import Late, Watched
from course.evidence.lateness import LOOKS, NOTED
from course.evidence.timeline import Timeline


@contextlib.contextmanager
def noted_lateness(timeline: Timeline) -> Iterator[None]:
    """Ask for the CPU again and again until the end, in a thread of its own, as a driver in its loop does."""
    over = threading.Event()

    def look() -> None:
        wanted = time.monotonic() + LOOKS
        while not over.wait(LOOKS):
            now = time.monotonic()
            if now - wanted > NOTED:
                timeline.add(Late(timeline.now(), round(now - wanted, 6)))
            wanted = time.monotonic() + LOOKS

    thread = threading.Thread(target=look, name="lateness", daemon=True)
    timeline.add(Watched(timeline.now(), True))
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join()
        timeline.add(Watched(timeline.now(), False))

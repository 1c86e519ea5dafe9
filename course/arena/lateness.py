"""Notes how late this machine lets programs go on, for those who judge milliseconds.

A thread of ours is soon let go on even where programs with more to do have to wait, so their own waits count,
too. What the machine itself had to wait for, on a host that it shares, only our thread sees.
"""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Iterator

from course.arena.waiting import longest, waited_below
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
    before = waited_below()
    timeline.add(Watched(timeline.now(), True))
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join()
        timeline.add(Watched(timeline.now(), False, longest(before, waited_below())))

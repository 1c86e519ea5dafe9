"""The one time line: events from many threads, and waiting for what they show."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from math import inf
from typing import TypeVar

from course.evidence.events import Event, MessageSeen

_E = TypeVar("_E", bound=Event)
# Two clocks read within this many seconds are read at the same moment; how often that is tried.
_AT_ONCE = 20e-6
_TRIES = 10


class Timeline:
    """Collects events from any thread, in the order of their arrival.

    Its clock begins at 0.0 when the object is made; it is the machine's monotonic clock.
    """

    def __init__(self) -> None:
        self._zero = time.monotonic()
        self._changed = threading.Condition()
        self._events: list[Event] = []

    def now(self) -> float:
        """Seconds since the recording began, in whole nanoseconds: those are what a file can keep."""
        return round(time.monotonic() - self._zero, 9)

    def when(self, wall_ns: int) -> float:
        """The moment that the wall clock gives as `wall_ns` (since 1970), as seconds of this time line.

        A step of the wall clock in between must not move it out of the recording: then it is now.
        """
        now, wall = self._both_clocks()
        ago = (wall - wall_ns) / 1e9
        return round(now - ago, 9) if 0.0 <= ago <= now else now

    def _both_clocks(self) -> tuple[float, int]:
        """This clock and the wall's (ns since 1970) at one moment.

        A thread that loses the CPU between the two would date what it has just received later than
        what comes next: then they are read again.
        """
        nearest, pair = inf, (0.0, 0)
        for _ in range(_TRIES):
            before, wall, after = self.now(), time.time_ns(), self.now()
            if after - before < nearest:
                nearest, pair = after - before, (after, wall)
            if nearest <= _AT_ONCE:
                break
        return pair

    def add(self, event: Event) -> None:
        with self._changed:
            self._events.append(event)
            self._changed.notify_all()

    def look_again(self) -> None:
        """Let those who wait look at their conditions: something changed that is no event."""
        with self._changed:
            self._changed.notify_all()

    def events(self) -> tuple[Event, ...]:
        """What has happened up to now, sorted by time; messages of a topic in the order of their delivery."""
        with self._changed:
            known = tuple(self._events)
        return tuple(sorted(_as_delivered(known), key=lambda event: event.t))

    def of(self, kind: type[_E]) -> Iterator[_E]:
        """Events of one kind, in the order of their arrival."""
        with self._changed:
            known = tuple(self._events)
        return (event for event in known if isinstance(event, kind))

    def wait_until(self, condition: Callable[[], bool], timeout: float) -> bool:
        """Wait until `condition()` holds; False at the time-out.

        It is looked at again after each event, and whenever `look_again` is called. It must be quick
        and must not wait itself.
        """
        with self._changed:
            return self._changed.wait_for(condition, timeout)


def _as_delivered(events: Sequence[Event]) -> list[Event]:
    """These events, in the order of their arrival, with no message dated after a later one of its topic.

    A message that is lost on the way and sent once more arrives after those that followed it; they are
    held back for it, so that it is delivered first. It was sent before they arrived: that is its time.
    """
    first: dict[str, float] = {}
    dated = []
    for event in reversed(events):
        if isinstance(event, MessageSeen):
            t = first[event.topic] = min(event.t, first.get(event.topic, inf))
            event = replace(event, t=t) if t < event.t else event
        dated.append(event)
    return dated[::-1]

"""The one time line: events from many threads, and waiting for what they show."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from typing import TypeVar

from course.evidence.events import Event

_E = TypeVar("_E", bound=Event)


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
        ago = (time.time_ns() - wall_ns) / 1e9
        now = self.now()
        return round(now - ago, 9) if 0.0 <= ago <= now else now

    def add(self, event: Event) -> None:
        with self._changed:
            self._events.append(event)
            self._changed.notify_all()

    def look_again(self) -> None:
        """Let those who wait look at their conditions: something changed that is no event."""
        with self._changed:
            self._changed.notify_all()

    def events(self) -> tuple[Event, ...]:
        """What has happened up to now, sorted by time."""
        with self._changed:
            return tuple(sorted(self._events, key=lambda event: event.t))

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

"""The one time line: events from many threads, and waiting for them."""

from __future__ import annotations

import threading
import time
from collections import defaultdict
from collections.abc import Callable, Hashable, Iterator, Sequence
from itertools import islice
from math import inf
from typing import Any, TypeVar

from course.model import replace
from course.model.events import Event, MessageSeen

_E = TypeVar("_E", bound=Event)
# Two clocks read within this many seconds count as read together; how often that is tried.
_AT_ONCE = 20e-6
_TRIES = 10


class Timeline:
    """Collects events from any thread, in the order of their arrival.

    Its clock is the machine's monotonic clock, and starts at 0.0 when the object is created.
    """

    def __init__(self) -> None:
        self._zero = time.monotonic()
        self._changed = threading.Condition()
        self._events: list[Event] = []
        self._of_kind: defaultdict[type[Event], list[Any]] = defaultdict(list)
        # For each thing counted: how many there are, and how many events were examined so far.
        self._counts: dict[Hashable, tuple[int, int]] = {}

    def now(self) -> float:
        """Seconds since the recording began, in whole nanoseconds, which is what a file can store."""
        return round(time.monotonic() - self._zero, 9)

    def when(self, wall_ns: int) -> float:
        """The wall-clock time `wall_ns` (ns since 1970) as seconds of this time line.

        If the wall clock was adjusted meanwhile, so that this is outside of the recording, returns `now()`.
        """
        now, wall = self._both_clocks()
        ago = (wall - wall_ns) / 1e9
        return round(now - ago, 9) if 0.0 <= ago <= now else now

    def at(self, monotonic: float) -> float:
        """A time of the machine's monotonic clock as seconds of this time line."""
        return round(monotonic - self._zero, 9)

    def _both_clocks(self) -> tuple[float, int]:
        """This clock and the wall clock (ns since 1970) at one moment.

        A thread that loses the CPU between the two readings would date a message later than the next one,
        so then they are read again.
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
            self._of_kind[type(event)].append(event)
            self._changed.notify_all()

    def look_again(self) -> None:
        """Make waiting threads check their conditions, after a change that is not an event."""
        with self._changed:
            self._changed.notify_all()

    def events(self) -> tuple[Event, ...]:
        """What has happened so far, sorted by time; messages of a topic in the order of delivery."""
        with self._changed:
            known = tuple(self._events)
        return tuple(sorted(_as_delivered(known), key=lambda event: event.t))

    def of(self, kind: type[_E]) -> Iterator[_E]:
        """Events of one kind so far, in the order of their arrival."""
        with self._changed:
            found: list[Any] = self._events if kind is Event else self._of_kind[kind]
            return islice(found, len(found))

    def count(self, kind: type[_E], text: Hashable, matches: Callable[[_E], bool]) -> int:
        """How many events of this kind match so far; each is examined once, however often this is called.

        text: what `matches` looks for, which tells one question from another.
        """
        with self._changed:
            found: list[_E] = self._of_kind[kind]
            count, looked_at = self._counts.get((kind, text), (0, 0))
            count += sum(map(matches, islice(found, looked_at, None)))
            self._counts[kind, text] = count, len(found)
            return count

    def wait_until(self, condition: Callable[[], bool], timeout: float) -> bool:
        """Wait until `condition()` is true; return False on timeout.

        It is checked after each event, and whenever `look_again` is called. It must be quick and must not
        wait itself.
        """
        with self._changed:
            return self._changed.wait_for(condition, timeout)


def _as_delivered(events: Sequence[Event]) -> list[Event]:
    """These events in order of arrival, with no message dated after a later one of its topic.

    A message that is lost on the way and sent again arrives after later ones, which are held back so that
    it is delivered first. It was sent before they arrived, so it gets their time.
    """
    first: dict[str, float] = {}
    dated = []
    for event in reversed(events):
        if isinstance(event, MessageSeen):
            t = first[event.topic] = min(event.t, first.get(event.topic, inf))
            event = replace(event, t=t) if t < event.t else event
        dated.append(event)
    return dated[::-1]

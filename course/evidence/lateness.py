"""How much the grading machine held everybody up, by what was noted in a recording."""

from __future__ import annotations

from collections.abc import Iterable

from course.evidence.events import Event, Late

# How often a thread of ours asks for the CPU while it is watched, and what counts as too late, in seconds.
LOOKS = 0.005
NOTED = 0.002
# Of the time. A loop of 2 ms that wakes as late as our looks did then leaves out one round in twenty.
_MOST = 0.005


def is_overloaded(events: Iterable[Event], begin: float, end: float) -> bool:
    """Whether the machine had too much to do from `begin` to `end` to judge a pace by milliseconds.

    Programs that sleep and wake in turns, as a driver does, got the CPU too late then, through no fault of
    theirs. False where nobody watched.
    """
    late = sum(event.seconds for event in events if isinstance(event, Late) and begin <= event.t <= end)
    return late > _MOST * (end - begin)

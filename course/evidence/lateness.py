"""How much the grading machine held everybody up, by what was noted in a recording."""

from __future__ import annotations

from collections.abc import Iterable

from course.evidence.events import Event, Late, Watched

# How often a thread of ours asks for the CPU while it is watched, and what counts as too late, in seconds.
LOOKS = 0.005
NOTED = 0.002
# Of the time. A loop of 2 ms that wakes as late as our looks did then leaves out one round in twenty.
_MOST = 0.005
# Of the time that was watched. A program whose thread had to wait that long may leave out as many rounds.
_MOST_WAITED = 0.05


def is_overloaded(events: Iterable[Event], begin: float, end: float) -> bool:
    """Whether the machine had too much to do from `begin` to `end` to judge a pace by milliseconds.

    Programs that sleep and wake in turns, as a driver does, got the CPU too late then, through no fault of
    theirs. False where nobody watched.
    """
    events = tuple(events)
    late = sum(event.seconds for event in events if isinstance(event, Late) and begin <= event.t <= end)
    return late > _MOST * (end - begin) or _waited(events, begin, end) > _MOST_WAITED


def _waited(events: Iterable[Event], begin: float, end: float) -> float:
    """Of the times watched that have some of it within, the greatest fraction that a thread had to wait."""
    watched = [event for event in events if isinstance(event, Watched)]
    times = zip(watched[::2], watched[1::2], strict=False)  # they come in turns
    within = ((on, off) for on, off in times if on.t <= end and off.t >= begin)
    return max((off.waited / (off.t - on.t) for on, off in within if on.t < off.t), default=0.0)

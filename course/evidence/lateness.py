"""How much the grading machine held everybody up, by what was noted in a recording."""

from __future__ import annotations

from collections.abc import Iterable

from course.evidence.events import Event, Late

# How often a thread of ours asks for the CPU while it is watched, and what counts as too late.
LOOKS = 0.005
NOTED = 0.002
# More of the looks than this were late: no rate and no delay of milliseconds is to be judged by it alone.
_MOST = 0.02
# One such wait is enough to hide what was to be measured.
_ENDLESS = 0.25


def is_overloaded(events: Iterable[Event], begin: float, end: float) -> bool:
    """Whether the machine had too much to do from `begin` to `end` to judge a pace by milliseconds.

    Programs that sleep and wake in turns, as a driver does, got the CPU too late then, through no fault of
    theirs. False where nobody watched.
    """
    late = [event.seconds for event in events if isinstance(event, Late) and begin <= event.t <= end]
    looks = max((end - begin) / LOOKS, 1.0)
    return bool(late) and (len(late) > max(_MOST * looks, 2) or max(late) > _ENDLESS)

"""Signals in a recording: the numbers in messages over time, and the time between messages."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice, pairwise
from typing import Any

from course.evidence.messages import Undecodable, UnknownType
from course.evidence.recording import ROSOUT, Recording
from course.model.events import MessageSeen, ServiceAnswered, ServiceCalled

FEWEST = 5  # messages for a plot to be useful
CURVES = 6
_DECODED = 3000  # messages of a topic, evenly chosen: six seconds at 500 Hz
_SMALL, _MARGIN = 0.5, 0.02  # of a recording, and of a signal: see `window_of`
_LARGEST = 64 * 1024
_MOST = 1e15  # nothing is less than "not a number"
_OF_NO_INTEREST = ("header", "stamp")
NOT_SHOWN = (ROSOUT, "/parameter_events")

Points = tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class Curve:
    label: str
    points: Points


@dataclass(frozen=True)
class Signal:
    """title: what it is, for people. unit: of the values; empty if it is not known."""

    title: str
    topic: str
    unit: str
    curves: tuple[Curve, ...]


def signals_of(recording: Recording) -> Iterator[Signal]:
    """At most one signal of values and one of intervals, of the busiest topics that have them."""
    enough = _enough(recording)
    values = (signal for messages in enough if (signal := _values(recording, messages)))
    yield from islice(values, 1)
    if enough:
        yield _intervals(enough[0])


def intervals_of(recording: Recording, topic: str) -> Signal | None:
    """The time between messages on that topic; None if there are too few."""
    return next((_intervals(one) for one in _enough(recording) if one[0].topic == topic), None)


def window_of(signal: Signal, duration: float) -> tuple[float, float]:
    """The seconds to draw: the whole recording, or only the signal's part if that is less than half."""
    times = [t for curve in signal.curves for t, _ in curve.points]
    first, last = min(times), max(times)
    if not 0 < last - first < _SMALL * duration:
        return 0.0, duration
    room = _MARGIN * (last - first)
    return max(first - room, 0.0), last + room


def latencies_of(recording: Recording) -> Signal | None:
    """How long each answer of the learner's busiest service took; None if there are too few."""
    calls = (event for event in recording.events if isinstance(event, ServiceCalled))
    asked = {event.call: event.t for event in calls if event.side == "client"}
    services: defaultdict[str, list[tuple[float, float]]] = defaultdict(list)
    for event in recording.events:
        if isinstance(event, ServiceAnswered) and event.call in asked:
            services[event.service].append((event.t, event.t - asked[event.call]))
    service, points = max(services.items(), key=lambda item: len(item[1]), default=("", []))
    if len(points) < FEWEST:
        return None
    return Signal("Time until the answer", service, "s", (Curve("since the call", tuple(points)),))


def _enough(recording: Recording) -> list[list[MessageSeen]]:
    """Messages by topic, the busiest topic first, without topics that have too few."""
    topics: defaultdict[str, list[MessageSeen]] = defaultdict(list)
    for event in recording.events:
        if isinstance(event, MessageSeen) and event.topic not in NOT_SHOWN:
            topics[event.topic].append(event)
    busiest = sorted(topics.values(), key=len, reverse=True)
    return [messages for messages in busiest if len(messages) >= FEWEST]


def _intervals(messages: Sequence[MessageSeen]) -> Signal:
    points = tuple((later.t, later.t - earlier.t) for earlier, later in pairwise(messages))
    topic = messages[0].topic
    return Signal("Time between messages", topic, "s", (Curve("since the one before", points),))


def _values(recording: Recording, messages: Sequence[MessageSeen]) -> Signal | None:
    """None if the messages contain no number that changes."""
    chosen = messages[:: math.ceil(len(messages) / _DECODED)]
    curves: defaultdict[str, list[tuple[float, float]]] = defaultdict(list)
    for message in chosen:
        for name, value in islice(_numbers(_decoded(recording, message)), CURVES):
            curves[name].append((message.t, value))
    told = [Curve(name, tuple(at)) for name, at in curves.items() if _changes(at)]
    topic = messages[0].topic
    return Signal("Values in the messages", topic, "", tuple(told[:CURVES])) if told else None


def _changes(points: Sequence[tuple[float, float]]) -> bool:
    return len(points) >= FEWEST and len({value for _, value in points}) > 1


def _decoded(recording: Recording, message: MessageSeen) -> Any:
    if len(message.data) > _LARGEST:
        return None
    try:
        return recording.decoder.decode(message.type, message.data)
    except (Undecodable, UnknownType, KeyError):
        return None


def _numbers(message: Any) -> Iterator[tuple[str, float]]:
    """Numeric fields by name. The positions of joints are listed by joint name."""
    names, positions = getattr(message, "name", None), getattr(message, "position", None)
    if isinstance(names, list) and isinstance(positions, list | tuple):
        given = map(str, names) if names else (f"joint {place + 1}" for place in range(len(positions)))
        yield from _plottable(zip(given, positions, strict=False))
        return
    for field in getattr(message, "__slots__", ()):
        if field not in _OF_NO_INTEREST:
            yield from _plottable(_of(str(field), getattr(message, field, None)))


def _of(name: str, value: Any) -> Iterator[tuple[str, Any]]:
    """A field's own value, the values of a list, or those of a nested message."""
    yield name, value
    if isinstance(value, list | tuple):
        yield from ((f"{name}[{place}]", item) for place, item in enumerate(value[:CURVES]))
    for inner in getattr(value, "__slots__", ()):
        yield f"{name}.{inner}", getattr(value, inner, None)


def _plottable(values: Iterable[tuple[str, Any]]) -> Iterator[tuple[str, float]]:
    for name, value in values:
        if isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < _MOST:
            yield name, float(value)

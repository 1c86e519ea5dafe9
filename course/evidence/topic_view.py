"""Messages of one topic as checks see them, and what can be expected of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import pairwise
from statistics import median
from typing import Any

from course.evidence.messages import Decoder
from course.evidence.unreadable import decoded
from course.feedback import Failure, Feedback, Pace

MIN_INTERVALS = 4


@dataclass(frozen=True)
class Message:
    """One message: when it arrived (s), its type, and its fields as attributes of `data`.

    Where the bytes are not a message of that type, `data` is false, and to read a field of it is
    the learner's failure.
    """

    t: float
    type: str
    data: Any

    @classmethod
    def of(cls, t: float, topic: str, type_name: str, data: bytes, decoder: Decoder) -> Message:
        return cls(t, type_name, decoded(topic, type_name, data, decoder))


@dataclass(frozen=True)
class LogLine:
    """One /rosout message. node: the logger's name. level: DEBUG, INFO, WARN, ERROR or FATAL."""

    t: float
    node: str
    level: str
    text: str

    @classmethod
    def of(cls, message: Message) -> LogLine:
        data = message.data
        if not data:
            return cls(message.t, "", "INFO", "")
        return cls(message.t, data.name, _LEVELS.get(data.level, str(data.level)), data.msg)


_LEVELS = {10: "DEBUG", 20: "INFO", 30: "WARN", 40: "ERROR", 50: "FATAL"}


@dataclass(frozen=True)
class TopicView:
    """What arrived on one topic. `lost`: messages that our own reception missed.

    watched: how long the recording lasted, in seconds. asked: told of each pace that is asked for.
    """

    name: str
    messages: tuple[Message, ...]
    lost: int
    watched: float
    asked: Callable[[Pace], None] = field(default=lambda pace: None, compare=False, repr=False)

    @property
    def times(self) -> tuple[float, ...]:
        return tuple(message.t for message in self.messages)

    def expect_period(self, period: float, *, tolerance: float = 0.2, advice: str | None = None) -> None:
        """The median interval is `period` seconds, within the fraction `tolerance`.

        Needs at least four intervals. Raises Failure with both figures otherwise.
        """
        self.asked(Pace(self.name, period * (1 - tolerance), period * (1 + tolerance)))
        expect_period(self.times, period, what=f"messages on {self.name}", tolerance=tolerance, advice=advice)


def expect_period(
    times: tuple[float, ...], period: float, *, what: str, tolerance: float = 0.2, advice: str | None = None
) -> None:
    """`times` (s, our own clock) come every `period` seconds by their median interval."""
    intervals = [later - earlier for earlier, later in pairwise(times)]
    if intervals and abs(median(intervals) - period) > tolerance * period:
        seen = median(intervals)
        raise Failure(
            Feedback(
                summary=f"The {what} come every {seconds(seen)}, not every {seconds(period)}.",
                expected=f"one every {seconds(period)} ({_hertz(period)})",
                seen=f"one every {seconds(seen)} ({_hertz(seen)})",
                advice=advice,
            )
        )
    if len(intervals) < MIN_INTERVALS:
        raise Failure(
            Feedback(
                summary=f"Only {len(times)} {what} came, too few to tell how often they come.",
                expected=f"at least {MIN_INTERVALS + 1}, one every {seconds(period)}",
                seen=f"{len(times)}",
                advice=advice,
            )
        )


def seconds(value: float) -> str:
    """A duration for people: `0.50 s`, `2.3 ms`."""
    return f"{value * 1000:.2g} ms" if value < 0.01 else f"{value:.2f} s"


def _hertz(period: float) -> str:
    return f"{1 / period:.3g} Hz" if period > 0 else "all at once"

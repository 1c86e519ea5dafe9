"""Messages of one topic as checks see them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import Any

from course.evidence.messages import Decoder, decoded
from course.model import replace
from course.model.feedback import Pace

MIN_INTERVALS = 4
# What the current check asks for. A recording is a value, so this is not stored in it.
_ASKED: ContextVar[list[Pace] | None] = ContextVar("paces", default=None)


@contextmanager
def paces_asked() -> Iterator[list[Pace]]:
    """The paces that a check asks for inside this context, in order, whether it passes or not."""
    asked: list[Pace] = []
    token = _ASKED.set(asked)
    try:
        yield asked
    finally:
        _ASKED.reset(token)


def ask_for(topic: str, shortest: float, longest: float) -> None:
    """Tell the report what time between two messages (s) a check wants, so that it can plot the range."""
    asked = _ASKED.get()
    if asked is not None:
        asked.append(Pace(topic, shortest, longest))


@dataclass(frozen=True)
class Message:
    """One message: when it arrived (s), its type, and its fields as attributes of `data`.

    If the bytes are not a message of that type, `data` is false, and reading one of its fields counts as
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
    """What arrived on one topic. lost: messages that our own subscription missed.

    watched: length of the recording (s).
    """

    name: str
    messages: tuple[Message, ...]
    lost: int
    watched: float

    @property
    def times(self) -> tuple[float, ...]:
        """When each message arrived (s)."""
        return tuple(message.t for message in self.messages)

    def between(self, begin: float, end: float) -> TopicView:
        """Return what arrived from `begin` (s) up to, but not including, `end` (s)."""
        return replace(self, messages=tuple(one for one in self.messages if begin <= one.t < end))


def seconds(value: float) -> str:
    """A duration for people: `0.50 s`, `2.3 ms`."""
    return f"{value * 1000:.2g} ms" if value < 0.01 else f"{value:.2f} s"


def hertz(period: float) -> str:
    """The rate of what comes once per `period` (s), for people: `2 Hz`."""
    if period <= 0:
        return "all at once"
    return f"{1 / period:.0f} Hz" if period <= 0.001 else f"{1 / period:.3g} Hz"

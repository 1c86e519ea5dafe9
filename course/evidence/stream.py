"""A stream: rows of numbers, each with the moment at which it came. Needs no ROS.

Plain Python does: ten seconds of six joints at 500 Hz are 30,000 numbers, and each question goes through them
once. numpy comes with ROS alone, and whoever judges a recording again has none.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable
from dataclasses import dataclass, replace
from math import inf

from course.evidence.topic_view import Message

Row = tuple[float, ...]


@dataclass(frozen=True)
class Stream:
    """`rows[i]` came at `times[i]` (s, our own clock, never falling); rows may differ in length.

    name: of the topic. lost: rows that our own reception missed.
    """

    name: str
    times: tuple[float, ...]
    rows: tuple[Row, ...]
    lost: int = 0

    @classmethod
    def of(cls, name: str, field: str, messages: Iterable[Message], lost: int = 0) -> Stream:
        """What the list `field` of these messages holds. A message that cannot be read raises Failure."""
        kept = tuple(messages)
        rows = (tuple(float(value) for value in getattr(message.data, field)) for message in kept)
        return cls(name, tuple(message.t for message in kept), tuple(rows), lost)

    def __len__(self) -> int:
        return len(self.times)

    def between(self, begin: float = -inf, end: float = inf) -> Stream:
        """The rows that came from `begin` to `end`, both included."""
        first, last = bisect_left(self.times, begin), bisect_right(self.times, end)
        return replace(self, times=self.times[first:last], rows=self.rows[first:last])

    def at(self, moment: float) -> Row | None:
        """The last row that had come by that moment."""
        place = bisect_right(self.times, moment)
        return self.rows[place - 1] if place else None

    def column(self, joint: int) -> Row:
        """The values of one joint. Raises IndexError where a row is too short."""
        return tuple(row[joint] for row in self.rows)

    @property
    def widths(self) -> tuple[int, ...]:
        """The lengths that its rows have, each once."""
        return tuple(sorted({len(row) for row in self.rows}))

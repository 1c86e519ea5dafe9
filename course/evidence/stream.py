"""A stream: rows of numbers, each with the time at which it arrived. Needs no ROS.

Plain Python is fast enough: ten seconds of six numbers at 500 Hz are 30,000 values, and each question reads
them once. numpy comes only with ROS, and a recording can be judged without ROS.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable
from dataclasses import dataclass
from math import inf

from course.evidence.topic_view import Message
from course.model import replace

Row = tuple[float, ...]


@dataclass(frozen=True)
class Stream:
    """`rows[i]` arrived at `times[i]` (s, our clock, never decreasing); rows may differ in length.

    name: of the topic. lost: rows that our own subscription missed.
    """

    name: str
    times: tuple[float, ...]
    rows: tuple[Row, ...]
    lost: int = 0

    @classmethod
    def of(cls, name: str, field: str, messages: Iterable[Message], lost: int = 0) -> Stream:
        """What the list `field` of these messages contains. An unreadable message raises Failure."""
        kept = tuple(messages)
        rows = (tuple(float(value) for value in getattr(message.data, field)) for message in kept)
        return cls(name, tuple(message.t for message in kept), tuple(rows), lost)

    def __len__(self) -> int:
        return len(self.times)

    def between(self, begin: float = -inf, end: float = inf) -> Stream:
        """Return the rows that arrived from `begin` to `end` (s), both included."""
        first, last = bisect_left(self.times, begin), bisect_right(self.times, end)
        return replace(self, times=self.times[first:last], rows=self.rows[first:last])

    def at(self, moment: float) -> Row | None:
        """Return the last row that had arrived by that moment (s); None if there was none."""
        place = bisect_right(self.times, moment)
        return self.rows[place - 1] if place else None

    def column(self, place: int) -> Row:
        """Return the values at index `place` (from 0). Raises IndexError if a row is too short."""
        return tuple(row[place] for row in self.rows)

    @property
    def widths(self) -> tuple[int, ...]:
        """The different lengths of its rows."""
        return tuple(sorted({len(row) for row in self.rows}))

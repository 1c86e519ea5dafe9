"""How regularly things arrive, from their times."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from statistics import median

FEWEST = 10  # times, at least, to measure a pace


@dataclass(frozen=True)
class Pacing:
    """The pace of `count` events. period, slow, jitter and gap are intervals between two events, in seconds.

    rate: the average number per second. period: the median interval. slow: the 99th percentile. jitter: the
    median distance of the intervals from the median. gap: the longest interval. dropped: how many events are
    missing from an even pace of `period`; events that were delayed and then came all at once don't count.
    """

    count: int
    rate: float
    period: float
    slow: float
    jitter: float
    gap: float
    dropped: int

    @property
    def words(self) -> tuple[str, ...]:
        """The figures, for people."""
        return (
            f"{self.count} messages, on average {self.rate:.1f} per second",
            f"between two: median {_ms(self.period)}, 99 of 100 within {_ms(self.slow)}, "
            f"jitter {_ms(self.jitter)}, longest {_ms(self.gap)}",
            f"dropped: {self.dropped}",
        )


def pacing_of(times: Sequence[float]) -> Pacing | None:
    """The pace of these times (s); None if there are fewer than ten, or all are the same."""
    if len(times) < FEWEST or times[-1] <= times[0]:
        return None
    between = sorted(later - earlier for earlier, later in pairwise(times))
    period = median(between)
    lasted = times[-1] - times[0]
    even = round(lasted / period) if period > 0 else 0
    return Pacing(
        count=len(times),
        rate=(len(times) - 1) / lasted,
        period=period,
        slow=between[math.ceil(0.99 * len(between)) - 1],
        jitter=median(abs(one - period) for one in between),
        gap=between[-1],
        dropped=max(0, even + 1 - len(times)),
    )


def _ms(seconds: float) -> str:
    return f"{seconds * 1000:.2f} ms"

"""How steadily things come, by the moments at which they came."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from statistics import median

FEWEST = 10  # moments, for a pace to be told


@dataclass(frozen=True)
class Pacing:
    """count: of the moments. period, slow, jitter, gap: seconds between two of them.

    rate: per second, on average. period: the median. slow: the 99th percentile. jitter: the median of how far
    they are off the median. gap: the longest. dropped: how many are missing from an even pace of `period`;
    those that were only held up, and then came all at once, are not.
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
    """None for fewer than ten moments, or when all came at once."""
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

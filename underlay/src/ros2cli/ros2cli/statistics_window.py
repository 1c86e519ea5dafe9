"""The latest values of something that is measured, and what can be told of them."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass


@dataclass(frozen=True)
class Summary:
    mean: float
    least: float
    most: float
    deviation: float
    count: int


class Window:
    """Keeps as many values as it has room for."""

    def __init__(self, size: int) -> None:
        self._values: deque[float] = deque(maxlen=size)

    def add(self, value: float) -> None:
        self._values.append(value)

    def __len__(self) -> int:
        return len(self._values)

    def summary(self) -> Summary:
        values = self._values
        mean = sum(values) / len(values)
        deviation = (sum((value - mean) ** 2 for value in values) / len(values)) ** 0.5
        return Summary(mean, min(values), max(values), deviation, len(values))

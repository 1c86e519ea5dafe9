"""Figures of a series of numbers, kept up to date without keeping the numbers."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum


class Statistics(Enum):
    """Which figure of a series: they are called as in C++."""

    Mean = 0
    Variance = 1
    StandardDeviation = 2
    Minimum = 3
    Maximum = 4


@dataclass
class RunningStatistics:
    """Takes numbers one by one and tells any of the Statistics so far; before the first it tells NaN."""

    count: int = 0
    mean: float = 0.0
    squares: float = 0.0  # of the distances to the mean, summed (Welford)
    minimum: float = math.inf
    maximum: float = -math.inf

    def add(self, value: float) -> None:
        self.count += 1
        distance = value - self.mean
        self.mean += distance / self.count
        self.squares += distance * (value - self.mean)
        self.minimum = min(self.minimum, value)
        self.maximum = max(self.maximum, value)

    def get(self, which: Statistics) -> float:
        if not self.count:
            return math.nan
        variance = self.squares / self.count
        return {
            Statistics.Mean: self.mean,
            Statistics.Variance: variance,
            Statistics.StandardDeviation: math.sqrt(variance),
            Statistics.Minimum: self.minimum,
            Statistics.Maximum: self.maximum,
        }[which]

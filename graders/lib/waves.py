"""Fits a sine to values over time, by least squares."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

FEWEST = 10  # values, for three unknowns and some noise


@dataclass(frozen=True)
class Wave:
    """offset + amplitude · sin(2π · frequency · t + phase), with t on the recording's clock.

    amplitude: not negative. phase: rad, from -π to π. rest: how far the values are off it (root of the mean
    square), in their unit.
    """

    frequency: float
    amplitude: float
    phase: float
    offset: float
    rest: float

    def behind(self, other: Wave) -> float:
        """How many seconds this one comes after `other`, of the same frequency: half a period at most."""
        turn = math.remainder(other.phase - self.phase, math.tau)
        return turn / (math.tau * self.frequency)


def fit_wave(times: Sequence[float], values: Sequence[float], frequency: float) -> Wave | None:
    """The sine of this frequency (Hz) that fits the values best.

    None if there are too few values, or all have the same time: then every sine fits equally well.
    """
    if len(times) < FEWEST:
        return None
    turn = math.tau * frequency
    middle = times[len(times) // 2]  # small arguments, exact sines
    rows = [(math.sin(turn * (t - middle)), math.cos(turn * (t - middle)), 1.0) for t in times]
    found = _least_squares(rows, values)
    if found is None:
        return None
    sine, cosine, offset = found
    off = (sine * a + cosine * b + offset - value for (a, b, _), value in zip(rows, values, strict=True))
    rest = math.sqrt(sum(one * one for one in off) / len(times))
    phase = math.remainder(math.atan2(cosine, sine) - turn * middle, math.tau)
    return Wave(frequency, math.hypot(sine, cosine), phase, offset, rest)


def _least_squares(
    rows: Sequence[tuple[float, float, float]], values: Sequence[float]
) -> tuple[float, float, float] | None:
    """The three factors that bring the columns of `rows` nearest to `values`, by the normal equations."""
    left = [[math.fsum(row[i] * row[j] for row in rows) for j in range(3)] for i in range(3)]
    right = [math.fsum(row[i] * value for row, value in zip(rows, values, strict=True)) for i in range(3)]
    whole = _determinant(left)
    if abs(whole) < 1e-6 * len(rows) ** 3:
        return None
    solved = []
    for place in range(3):
        replaced = [[*row[:place], right[i], *row[place + 1 :]] for i, row in enumerate(left)]
        solved.append(_determinant(replaced) / whole)
    return solved[0], solved[1], solved[2]


def _determinant(m: list[list[float]]) -> float:
    return (
        m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
        - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
    )

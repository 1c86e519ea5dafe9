"""Sines found by least squares."""

from __future__ import annotations

import math
import random

import pytest

from lib.waves import fit_wave

from .streams import ticks


@pytest.mark.parametrize("seed", range(30))
def test_a_sine_is_found_again(seed: int) -> None:
    chance = random.Random(seed)
    frequency, amplitude = chance.uniform(0.2, 5), chance.uniform(0.01, 3)
    phase, offset = chance.uniform(-math.pi, math.pi), chance.uniform(-5, 5)
    begin, noise = chance.uniform(0, 100), 0.02 * amplitude
    times = [begin + t for t in ticks(seed, 0.004, 2 / frequency, jitter=0.8, drop=0.2)]
    values = [
        offset + amplitude * math.sin(math.tau * frequency * t + phase) + chance.uniform(-noise, noise)
        for t in times
    ]
    found = fit_wave(times, values, frequency)
    assert found.amplitude == pytest.approx(amplitude, rel=0.02)
    assert found.offset == pytest.approx(offset, abs=0.02 * amplitude)
    assert math.remainder(found.phase - phase, math.tau) == pytest.approx(0, abs=0.02)
    assert found.rest < noise


@pytest.mark.parametrize("late", [-0.2, -0.01, 0.0, 0.004, 0.05, 0.4])
def test_how_far_one_is_behind_the_other(late: float) -> None:
    times = ticks(1, 0.002, 3.0)
    one, other = (
        fit_wave(times, [math.sin(math.tau * (t - by) + 3) for t in times], 1.0) for by in (0.0, late)
    )
    assert one is not None and other is not None
    assert other.behind(one) == pytest.approx(late, abs=1e-6)


def test_half_a_period_will_do() -> None:
    times = range(520)
    values = [0.3 + 0.17 * math.sin(place / (50 * math.pi)) for place in times]
    found = fit_wave(times, values, 1 / (100 * math.pi**2))
    assert (found.amplitude, found.offset) == (pytest.approx(0.17), pytest.approx(0.3))
    assert found.rest == pytest.approx(0, abs=1e-6)


def test_what_is_no_sine_has_a_rest() -> None:
    times = ticks(1, 0.01, 2.0)
    found = fit_wave(times, [1.0 if t % 1 < 0.5 else -1.0 for t in times], 1.0)
    assert found.rest > 0.4


@pytest.mark.parametrize("times", [[], [0.1] * 9, [0.1] * 50])
def test_nothing_can_be_told(times: list[float]) -> None:
    assert fit_wave(times, [1.0] * len(times), 1.0) is None

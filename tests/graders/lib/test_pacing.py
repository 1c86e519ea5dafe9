"""How steadily messages come."""

from __future__ import annotations

import pytest

from lib.pacing import pacing_of

from .streams import held_up, ticks

SEEDS = range(20)


@pytest.mark.parametrize("period", [0.0005, 0.002, 0.01, 0.5])
def test_an_even_pace(period: float) -> None:
    pacing = pacing_of(ticks(1, period, 100 * period))
    assert (pacing.count, pacing.dropped) == (101, 0)
    assert pacing.rate == pytest.approx(1 / period)
    assert pacing.period == pytest.approx(period)
    assert pacing.jitter == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("seed", SEEDS)
def test_jitter_changes_neither_rate_nor_median(seed: int) -> None:
    pacing = pacing_of(ticks(seed, 0.002, 4.0, jitter=0.5))
    assert pacing.rate == pytest.approx(500, rel=0.01)
    assert pacing.period == pytest.approx(0.002, rel=0.05)
    assert pacing.jitter > 0.0001
    assert pacing.period < pacing.slow <= pacing.gap < 0.0031


@pytest.mark.parametrize("seed", SEEDS)
def test_what_is_missing_is_counted(seed: int) -> None:
    times = ticks(seed, 0.002, 4.0, drop=0.1)
    pacing = pacing_of(times)
    missing = round((times[-1] - times[0]) / 0.002) + 1 - len(times)
    assert pacing.dropped == missing > 100
    assert pacing.period == pytest.approx(0.002)
    assert pacing.rate == pytest.approx(450, rel=0.05)


def test_what_was_held_up_is_not_missing() -> None:
    pacing = pacing_of(held_up(ticks(1, 0.002, 4.0), 1.0, 1.3))
    assert pacing.dropped == 0
    assert pacing.rate == pytest.approx(500, rel=0.001)
    assert pacing.gap == pytest.approx(0.302)


def test_its_words() -> None:
    pacing = pacing_of(ticks(1, 0.002, 1.0))
    assert pacing.words == (
        "501 messages, on average 500.0 per second",
        "between two: median 2.00 ms, 99 of 100 within 2.00 ms, jitter 0.00 ms, longest 2.00 ms",
        "dropped: 0",
    )


@pytest.mark.parametrize("times", [[], [1.0], [float(t) for t in range(9)], [2.0] * 50])
def test_too_few_to_tell(times: list[float]) -> None:
    assert pacing_of(times) is None


def test_most_of_them_at_once() -> None:
    pacing = pacing_of([0.0] * 40 + [1.0])
    assert (pacing.period, pacing.dropped) == (0.0, 0)

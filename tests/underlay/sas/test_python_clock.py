"""sas_core in Python, in a time of the test's own."""

from __future__ import annotations

import importlib
import math
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from sas_core import Clock, Statistics

MILLI = 1_000_000


class Time:
    """Goes on by what is slept, a little longer than asked, and by what the test says."""

    late = 0

    def __init__(self) -> None:
        self.now = 5_000 * MILLI

    def monotonic_ns(self) -> int:
        return self.now

    def sleep(self, seconds: float) -> None:
        assert seconds >= 0
        self.now += round(seconds * 1e9) + self.late


@pytest.fixture
def time(monkeypatch: pytest.MonkeyPatch) -> Time:
    time = Time()
    monkeypatch.setattr(importlib.import_module("sas_core.clock"), "time", time)
    return time


@pytest.fixture
def clock(time: Time) -> Clock:
    clock = importlib.import_module("sas_core").Clock(0.01)
    clock.init()
    return clock


@pytest.fixture
def statistics() -> type[Statistics]:
    return importlib.import_module("sas_core").Statistics


def test_late_rounds_do_not_shift_those_after_them(time: Time, clock: Clock) -> None:
    time.late = MILLI
    for number in range(1, 100):
        time.now += 3 * MILLI
        clock.update_and_sleep()
        assert time.now == 5_000 * MILLI + 10 * number * MILLI + MILLI
    assert clock.get_overrun_count() == 0
    assert clock.get_elapsed_time_sec() == pytest.approx(0.991)


def test_moments_that_were_missed_are_left_out_and_counted(time: Time, clock: Clock) -> None:
    time.now += 35 * MILLI
    clock.update_and_sleep()
    assert (time.now, clock.get_overrun_count()) == (5_040 * MILLI, 3)


def test_figures_of_all_rounds(time: Time, clock: Clock, statistics: type[Statistics]) -> None:
    kinds = type(clock).TimeType
    assert math.isnan(clock.get_statistics(statistics.Mean, kinds.Idle))
    for milliseconds in (2, 4, 6):
        time.now += milliseconds * MILLI
        clock.update_and_sleep()
    found = {which.name: clock.get_statistics(which, kinds.Computational) for which in statistics}
    assert found == pytest.approx(
        {
            "Mean": 0.004,
            "Variance": 8e-6 / 3,
            "StandardDeviation": math.sqrt(8e-6 / 3),
            "Minimum": 0.002,
            "Maximum": 0.006,
        }
    )
    assert clock.get_statistics(statistics.Mean, kinds.Idle) == pytest.approx(0.006)
    assert clock.get_statistics(statistics.Mean, kinds.EffectiveSampling) == pytest.approx(0.01)
    last = (clock.get_computation_time(), clock.get_sleep_time())
    assert last == pytest.approx((0.006, 0.004))
    assert [clock.get_time(kind) for kind in kinds] == pytest.approx([0.006, 0.01, 0.004])
    assert clock.get_effective_thread_sampling_time_sec() == pytest.approx(0.01)
    assert clock.get_desired_thread_sampling_time_sec() == 0.01


def test_init_begins_anew(time: Time, clock: Clock, statistics: type[Statistics]) -> None:
    time.now += 35 * MILLI
    clock.update_and_sleep()
    clock.init()
    assert (clock.get_overrun_count(), clock.get_elapsed_time_sec()) == (0, 0.0)
    assert math.isnan(clock.get_statistics(statistics.Mean, type(clock).TimeType.Computational))


def test_a_clock_that_nobody_started_starts_itself(time: Time) -> None:
    clock = importlib.import_module("sas_core").Clock(0.01)
    assert clock.get_elapsed_time_sec() == 0.0
    clock.update_and_sleep()
    assert (time.now, clock.get_overrun_count()) == (5_010 * MILLI, 0)


@pytest.mark.parametrize("seconds", [0.0, -1.0])
def test_a_clock_needs_a_sampling_time(seconds: float) -> None:
    with pytest.raises(ValueError, match="sampling time must be positive"):
        importlib.import_module("sas_core").Clock(seconds)


def test_sleeping_for_some_time(time: Time) -> None:
    clock = importlib.import_module("sas_core").Clock
    clock.safe_sleep_seconds(-1.0)
    clock.safe_sleep_seconds(2.0)
    assert time.now == 7_000 * MILLI

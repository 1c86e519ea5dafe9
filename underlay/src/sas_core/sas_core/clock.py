"""The clock of a loop that runs at a fixed rate; it behaves as sas::Clock does in C++."""

from __future__ import annotations

import time
from enum import Enum

from sas_core.statistics import RunningStatistics, Statistics

_NANO = 1_000_000_000


class Clock:
    """Call init() before the loop and update_and_sleep() once in it.

    The loop goes on at init() + 1, 2, 3, ... sampling times: late rounds do not shift later ones. Where a
    round takes longer than the sampling time, the moments that were missed are left out, and counted.
    """

    class TimeType(Enum):
        """Of each round: the loop's own work, that and the sleep after it together, and the sleep."""

        Computational = 0
        EffectiveSampling = 1
        Idle = 2

    def __init__(self, thread_sampling_time_sec: float) -> None:
        """Raise ValueError for a sampling time that is not positive."""
        self._sampling_time = round(thread_sampling_time_sec * _NANO)
        if self._sampling_time <= 0:
            raise ValueError(
                f"Clock: the sampling time must be positive, in seconds; it is {thread_sampling_time_sec}."
            )
        self._initial: int | None = None
        self._start(0)

    def init(self) -> None:
        """Start counting now; figures of an earlier loop are forgotten."""
        self._initial = time.monotonic_ns()
        self._start(self._initial)

    def update_and_sleep(self) -> None:
        """Sleep until the next moment; starts the clock if nobody has."""
        if self._initial is None:
            self.init()
        done, before = time.monotonic_ns(), self._woke_up
        self._deadline += self._sampling_time
        if self._deadline <= done:
            missed = (done - self._deadline) // self._sampling_time + 1
            self._overrun_count += missed
            self._deadline += missed * self._sampling_time
        self._woke_up = _sleep_until(self._deadline)
        self._record(Clock.TimeType.Computational, done - before)
        self._record(Clock.TimeType.Idle, self._woke_up - done)
        self._record(Clock.TimeType.EffectiveSampling, self._woke_up - before)

    @staticmethod
    def safe_sleep_seconds(seconds: float) -> None:
        """Sleep for that long; Ctrl+C ends it."""
        time.sleep(max(seconds, 0.0))

    @staticmethod
    def blocking_sleep_seconds(seconds: float) -> None:
        """Sleep for that long; Ctrl+C ends it."""
        time.sleep(max(seconds, 0.0))

    def get_time(self, time_type: TimeType) -> float:
        """Of the last round, in seconds; 0 before the first."""
        return self._last[time_type]

    def get_desired_thread_sampling_time_sec(self) -> float:
        return self._sampling_time / _NANO

    def get_effective_thread_sampling_time_sec(self) -> float:
        """Of the last round, in seconds."""
        return self._last[Clock.TimeType.EffectiveSampling]

    def get_computation_time(self) -> float:
        """Of the last round, in seconds."""
        return self._last[Clock.TimeType.Computational]

    def get_sleep_time(self) -> float:
        """Of the last round, in seconds."""
        return self._last[Clock.TimeType.Idle]

    def get_elapsed_time_sec(self) -> float:
        """Since init()."""
        return 0.0 if self._initial is None else (time.monotonic_ns() - self._initial) / _NANO

    def get_overrun_count(self) -> int:
        """How many moments were missed since init()."""
        return self._overrun_count

    def get_statistics(self, statistics: Statistics, time_type: TimeType) -> float:
        """A figure in seconds over all rounds since init(); NaN before the first."""
        return self._series[time_type].get(statistics)

    def _start(self, now: int) -> None:
        self._deadline = self._woke_up = now
        self._overrun_count = 0
        self._last = dict.fromkeys(Clock.TimeType, 0.0)
        self._series = {time_type: RunningStatistics() for time_type in Clock.TimeType}

    def _record(self, time_type: TimeType, nanoseconds: int) -> None:
        self._last[time_type] = nanoseconds / _NANO
        self._series[time_type].add(nanoseconds / _NANO)


def _sleep_until(moment: int) -> int:
    """When we woke up; all in nanoseconds of the monotonic clock."""
    while (now := time.monotonic_ns()) < moment:
        time.sleep((moment - now) / _NANO)
    return now

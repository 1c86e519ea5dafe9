"""How late a process gets the CPU, measured by itself."""

from __future__ import annotations

import threading
import time

from course.grading import lag as module
from course.grading.lag import measured_lag


def test_a_pause_of_the_whole_process_is_seen() -> None:
    before = threading.active_count()
    with measured_lag() as lag:
        deadline = time.monotonic() + 0.05
        while time.monotonic() < deadline:
            pass
        holding_the_interpreter(0.3)
        assert wait_for(lambda: lag.worst > 0.1)
    assert threading.active_count() == before


def test_waiting_in_peace_is_no_lag(monkeypatch: object) -> None:
    with measured_lag() as lag:
        threading.Event().wait(0.1)
    assert lag.worst >= 0.0
    assert module._PERIOD < 0.05  # finer than what is judged by it


def holding_the_interpreter(seconds: float) -> None:
    """As one long call that lets no other thread run."""
    import ctypes

    ctypes.PyDLL(None).usleep(int(seconds * 1e6))


def wait_for(condition: object) -> bool:
    event = threading.Event()
    for _ in range(1000):
        if condition():  # type: ignore[operator]
            return True
        event.wait(0.01)
    return False

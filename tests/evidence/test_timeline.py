"""One time line for many threads."""

from __future__ import annotations

import threading
import time

from course.evidence.events import Event, Marked, OutputLine
from course.evidence.timeline import Timeline

WAIT = 20.0


def test_its_clock_goes_on_in_whole_nanoseconds() -> None:
    timeline = Timeline()
    times = [timeline.now() for _ in range(1000)]
    assert times == sorted(times)
    assert 0.0 <= times[0] < WAIT
    assert [round(t * 1e9) / 1e9 for t in times] == times


def test_events_are_sorted_by_time_and_then_by_arrival() -> None:
    timeline = Timeline()
    late, one, two = Marked(2.0, "late"), Marked(1.0, "one"), Marked(1.0, "two")
    for event in (late, one, two):
        timeline.add(event)
    assert timeline.events() == (one, two, late)
    assert list(timeline.of(Marked)) == [late, one, two]
    assert list(timeline.of(OutputLine)) == []


def test_waiting_ends_with_the_event() -> None:
    timeline = Timeline()
    waiting = threading.Event()

    def condition() -> bool:
        waiting.set()
        return any(timeline.of(Marked))

    def add() -> None:
        assert waiting.wait(WAIT)
        timeline.add(Marked(1.0, "done"))

    thread = threading.Thread(target=add)
    thread.start()
    began = time.monotonic()
    assert timeline.wait_until(condition, WAIT)
    assert time.monotonic() - began < WAIT / 2  # by the event, not by the time-out
    thread.join()


def test_waiting_ends_without_the_event() -> None:
    assert not Timeline().wait_until(lambda: False, 0.01)
    assert Timeline().wait_until(lambda: True, 0.0)


def test_no_event_is_lost_between_threads() -> None:
    timeline = Timeline()

    def add(name: str) -> None:
        for n in range(500):
            timeline.add(OutputLine(float(n), name, str(n)))

    threads = [threading.Thread(target=add, args=(str(n),)) for n in range(8)]
    for thread in threads:
        thread.start()
    assert timeline.wait_until(lambda: sum(1 for _ in timeline.of(Event)) == 4000, WAIT)
    for thread in threads:
        thread.join()

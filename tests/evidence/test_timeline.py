"""One time line for many threads."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator

import pytest

from course.evidence.timeline import Timeline
from course.model.events import Event, Marked, MessageSeen, OutputLine

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


class Looked(str):
    """A text that counts how often somebody searches in one."""

    times = 0

    def __contains__(self, text: object) -> bool:
        Looked.times += 1
        return super().__contains__(text)


def test_a_condition_looks_at_each_event_once_however_often_it_is_asked(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Otherwise the work grows with the square of the output."""
    monkeypatch.setattr(Looked, "times", 0)
    timeline, counts = Timeline(), []
    for number in range(500):
        timeline.add(OutputLine(number / 1e3, "talker", Looked(f"line {number}")))
        timeline.add(Marked(number / 1e3, "in between"))
        counts.append(timeline.count(OutputLine, "9", lambda event: "9" in event.text))
    assert counts[-1] == sum("9" in str(number) for number in range(500)) and counts == sorted(counts)
    assert Looked.times == 500
    assert timeline.count(OutputLine, "line 7", lambda event: "line 7" in event.text) == 11


def test_events_of_one_kind_are_found_without_going_through_the_others() -> None:
    timeline = Timeline()
    timeline.add(Marked(0.0, "first"))
    found = timeline.of(Marked)
    for number in range(100):
        timeline.add(OutputLine(0.1, "talker", str(number)))
    timeline.add(Marked(0.2, "later"))
    visited = 0

    class Counted(list[Event]):
        def __iter__(self) -> Iterator[Event]:
            nonlocal visited
            visited += len(self)
            return super().__iter__()

    timeline._events = Counted(timeline._events)
    assert [mark.name for mark in timeline.of(Marked)] == ["first", "later"]
    assert visited == 0
    assert [mark.name for mark in found] == ["first"]  # as it was when it was asked


def seen(t: float, topic: str, text: str) -> MessageSeen:
    return MessageSeen(t, topic, "std_msgs/msg/String", text.encode())


def test_a_message_that_was_sent_once_more_stays_before_those_that_waited_for_it() -> None:
    timeline = Timeline()
    for event in (seen(1.0, "/a", "0"), seen(3.5, "/a", "1"), seen(2.0, "/a", "2"), seen(3.0, "/a", "3")):
        timeline.add(event)
    timeline.add(seen(2.5, "/b", "another topic"))
    assert [(event.t, event.data) for event in timeline.events() if isinstance(event, MessageSeen)] == [
        (1.0, b"0"),
        (2.0, b"1"),
        (2.0, b"2"),
        (2.5, b"another topic"),
        (3.0, b"3"),
    ]


def test_a_moment_of_the_wall_clock_is_found_where_the_cpu_is_lost_in_between(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    clock, lost = [100.0], iter((0.5,))

    def time_ns() -> int:
        found = round(clock[0] * 1e9)
        clock[0] += next(lost, 0.0)
        return found

    monkeypatch.setattr(time, "monotonic", lambda: clock[0])
    monkeypatch.setattr(time, "time_ns", time_ns)
    timeline = Timeline()
    clock[0] = 103.0
    assert timeline.when(102_000_000_000) == 2.0
    assert clock[0] == 103.5  # it was lost


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

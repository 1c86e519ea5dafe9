"""Notes on how late this machine lets a thread go on."""

from __future__ import annotations

import subprocess
import sys

import pytest

from course.arena import lateness
from course.arena.lateness import noted_lateness
from course.arena.waiting import longest, waited_below
from course.evidence.events import Late, Watched
from course.evidence.timeline import Timeline

from .conftest import WAIT


def test_what_is_later_than_allowed_is_noted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(lateness, "NOTED", -1.0)  # every look is too late for that
    timeline = Timeline()
    with noted_lateness(timeline):
        assert timeline.wait_until(lambda: any(timeline.of(Late)), WAIT)
    assert [event.on for event in timeline.of(Watched)] == [True, False]


def test_what_is_in_time_is_not(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(lateness, "NOTED", 1e9)
    timeline = Timeline()
    with noted_lateness(timeline):
        timeline.wait_until(lambda: False, 3 * lateness.LOOKS)
    assert not list(timeline.of(Late))


def test_waits_of_a_program_are_noted(monkeypatch: pytest.MonkeyPatch) -> None:
    waits = iter([{1: 0.5, 2: 7.0}, {1: 0.75, 2: 7.125, 3: 0.0625}])
    monkeypatch.setattr(lateness, "waited_below", lambda: next(waits))
    timeline = Timeline()
    with noted_lateness(timeline):
        pass
    assert [event.waited for event in timeline.of(Watched)] == [0.0, 0.25]


def test_a_thread_that_shares_its_processor_waits() -> None:
    """Two of them on one processor, each of which wants all of it."""
    spin = "import os\nos.sched_setaffinity(0, {min(os.sched_getaffinity(0))})\nwhile True: pass"
    command = [sys.executable, "-c", spin]
    with subprocess.Popen(command) as one, subprocess.Popen(command) as two:
        try:
            before = waited_below()
            assert Timeline().wait_until(lambda: longest(before, waited_below()) > 0.1, WAIT)
            assert {one.pid, two.pid} <= waited_below().keys()
        finally:
            one.kill()
            two.kill()


def test_threads_that_have_ended_or_begun() -> None:
    assert longest({1: 2.0}, {}) == 0.0
    assert longest({}, {1: 2.0}) == 2.0

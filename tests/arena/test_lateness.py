"""Notes on how late this machine lets a thread go on."""

from __future__ import annotations

import pytest

from course.arena import lateness
from course.arena.lateness import noted_lateness
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

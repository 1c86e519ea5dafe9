"""What a node publishes, against what its parameters say."""

from __future__ import annotations

import pytest

from course.errors import OurFault
from course.evidence.events import Event, MessageSeen
from course.evidence.recording import Recording
from course.grading.expect.configured import (
    expect_followed,
    expect_pace,
    expect_pace_kept,
    expect_texts,
    reading,
)

from . import conftest
from .conftest import QUOTE, record, said, sent, told, where
from .parameter_calls import DEFINITIONS, NODE, set_to

TOPIC = "/quotes"
CODE = """\
def __init__(self):
    self.declare_parameter('period', 0.5)
    self.declare_parameter('quote', 'a')
    period = self.get_parameter('period').value
    self.create_timer(period, self.tick)
def tick(self):
    message.quote = self.get_parameter('quote').value
    self.publisher.publish(message)
"""
ONCE = CODE.replace("    message.quote = self.get_parameter('quote').value\n", "")


@pytest.fixture(autouse=True)
def _definitions(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(conftest, "DEFINITIONS", {**conftest.DEFINITIONS, **DEFINITIONS})


def seen(t: float, quote: str, author: str = "Ann") -> MessageSeen:
    return MessageSeen(t, TOPIC, QUOTE, sent(t, 1, quote, author).data)


def published(*events: Event, code: str = CODE) -> Recording:
    return record(*events, code=code)


def every(period: float) -> tuple[float, ...]:
    return tuple(1.0 + n * period for n in range(5))


# pace


def test_the_pace_that_the_parameter_says() -> None:
    assert said(expect_pace, published(), every(0.5), 0.5, parameter="period") is None
    found = told(expect_pace, published(), every(1.0), 0.5, parameter="period")
    assert "get_parameter('period')" in str(found.advice)
    assert where(found) == ["talk/talker.py:5"]


def test_a_pace_that_is_kept() -> None:
    assert said(expect_pace_kept, published(), every(0.5), 0.5, parameter="period", value=0.1) is None
    found = told(expect_pace_kept, published(), every(0.1), 0.5, parameter="period", value=0.1)
    assert found.summary.startswith(
        "`period` was set to 0.1 while the node ran. The messages come every 0.10 s"
    )
    assert where(found) == ["talk/talker.py:4"]


# texts


def test_texts() -> None:
    recording = published(seen(1.0, "Go", "Bob"))
    (message,) = recording.messages(TOPIC)
    assert said(expect_texts, recording, message, {"quote": "Go", "author": "Bob"}) is None
    found = told(expect_texts, recording, message, {"quote": "Stop"})
    assert (found.expected, found.seen) == ("Stop", "Go")
    assert "get_parameter('quote')" in str(found.advice)
    assert where(found) == ["talk/talker.py:7"]
    found = told(expect_texts, recording, message, {"quote": "Bob", "author": "Go"})
    assert "swapped" in str(found.advice)


# changes


def test_a_change_that_is_followed() -> None:
    change = set_to(1.0, "quote", "new", "")
    recording = published(seen(0.9, "old"), *change, seen(1.2, "old"), seen(1.4, "new"), seen(1.6, "new"))
    assert said(expect_followed, recording, NODE, TOPIC, "quote") is None


def test_a_change_that_is_not_followed() -> None:
    change = set_to(1.0, "quote", "new", "")
    old = (seen(1.2, "old"), seen(1.4, "old"))
    found = told(expect_followed, published(*change, *old), NODE, TOPIC, "quote")
    assert (found.expected, found.seen) == ("new", "old")
    assert where(found) == ["talk/talker.py:7"]
    once = ONCE.replace("    period =", "    text = self.get_parameter('quote').value\n    period =")
    found = told(expect_followed, published(*change, *old, code=once), NODE, TOPIC, "quote")
    assert "read once" in str(found.advice)
    assert where(found) == ["talk/talker.py:4"]


def test_silence_after_a_change() -> None:
    change = set_to(1.0, "quote", "new", "")
    found = told(expect_followed, published(*change, seen(1.2, "new")), NODE, TOPIC, "quote")
    assert found.summary == "Once `quote` was set, no more messages came."


def test_a_change_that_the_scenario_did_not_make() -> None:
    with pytest.raises(OurFault, match="quote"):
        expect_followed(published(), NODE, TOPIC, "quote")


def test_where_a_parameter_is_read() -> None:
    assert [place.line for place in reading(published().sources, "period")] == [4]

"""What a node publishes, compared with its parameters."""

from __future__ import annotations

import pytest

from course.errors import OurFault
from course.evidence.recording import Recording
from course.evidence.topic_view import Message, TopicView
from course.model.events import Event, MessageSeen
from lib.configured import (
    expect_followed,
    expect_period_kept,
    expect_texts,
    reading,
)
from tests.golden import golden
from tests.grading.expect import conftest
from tests.grading.expect.conftest import QUOTE, record, said, sent, told
from tests.grading.expect.parameter_calls import DEFINITIONS, NODE, set_to

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


def every(period: float) -> TopicView:
    messages = tuple(Message(1.0 + n * period, QUOTE, None) for n in range(5))
    return TopicView(TOPIC, messages, 0, 9.0)


# pace


def test_a_pace_that_is_kept() -> None:
    assert said(expect_period_kept, published(), every(0.5), 0.5, parameter="period", value=0.1) is None
    golden(told(expect_period_kept, published(), every(0.1), 0.5, parameter="period", value=0.1))


# texts


def test_texts() -> None:
    recording = published(seen(1.0, "Go", "Bob"))
    (message,) = recording.messages(TOPIC)
    assert said(expect_texts, recording, message, {"quote": "Go", "author": "Bob"}) is None
    golden(told(expect_texts, recording, message, {"quote": "Stop"}))
    golden(told(expect_texts, recording, message, {"quote": "Bob", "author": "Go"}))


# changes


def test_a_change_that_is_followed() -> None:
    change = set_to(1.0, "quote", "new", "")
    recording = published(seen(0.9, "old"), *change, seen(1.2, "old"), seen(1.4, "new"), seen(1.6, "new"))
    assert said(expect_followed, recording, NODE, TOPIC, "quote") is None


def test_a_change_that_is_not_followed() -> None:
    change = set_to(1.0, "quote", "new", "")
    old = (seen(1.2, "old"), seen(1.4, "old"))
    golden(told(expect_followed, published(*change, *old), NODE, TOPIC, "quote"))
    once = ONCE.replace("    period =", "    text = self.get_parameter('quote').value\n    period =")
    golden(told(expect_followed, published(*change, *old, code=once), NODE, TOPIC, "quote"))


def test_silence_after_a_change() -> None:
    change = set_to(1.0, "quote", "new", "")
    golden(told(expect_followed, published(*change, seen(1.2, "new")), NODE, TOPIC, "quote"))


def test_a_change_that_the_scenario_did_not_make() -> None:
    with pytest.raises(OurFault, match="quote"):
        expect_followed(published(), NODE, TOPIC, "quote")


def test_where_a_parameter_is_read() -> None:
    assert [place.line for place in reading(published().sources, "period")] == [4]

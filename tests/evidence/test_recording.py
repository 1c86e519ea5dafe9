"""Questions that checks ask of a recording."""

from __future__ import annotations

import signal
from struct import pack

import pytest

from course.evidence.recording import ROSOUT, ROSOUT_TYPE, Recording
from course.model import replace
from course.model.events import (
    Event,
    ExecutableMissing,
    FileKept,
    GraphSeen,
    LimitReached,
    Marked,
    MessageSeen,
    MessageSent,
    MessagesLost,
    OutputLine,
    ProcessExited,
    SignalSent,
)
from course.model.graph import Endpoint, Graph, Qos, Service

from .conftest import HELLO, STRING

LOG = "uint32 level\nstring name\nstring msg\n"


def string(text: str) -> bytes:
    data = text.encode() + b"\0"
    return pack("<I", len(data)) + data + bytes(-len(data) % 4)


def log(t: float, name: str, text: str, level: int = 20) -> MessageSeen:
    return MessageSeen(t, ROSOUT, ROSOUT_TYPE, b"\0\1\0\0" + pack("<I", level) + string(name) + string(text))


def record(*events: Event) -> Recording:
    return Recording("x", events, {STRING: "string data", ROSOUT_TYPE: LOG}, duration=3.0)


def test_messages_of_a_topic_in_their_order() -> None:
    other = HELLO.replace(b"hello", b"other")
    found = record(
        MessageSeen(1.0, "/talk", STRING, HELLO),
        MessageSent(1.1, "/talk", STRING, other),
        MessageSeen(1.2, "/other", STRING, other),
        MessageSeen(1.3, "/talk", STRING, b""),
        MessagesLost(1.4, "/talk", 2),
        MessagesLost(1.5, "/other", 5),
        MessagesLost(1.6, "/talk", 1),
    )
    assert [(m.t, bool(m.data)) for m in found.messages("/talk")] == [(1.0, True), (1.3, False)]
    assert found.messages("/talk")[0].data.data == "hello"
    assert [m.data.data for m in found.sent("/talk")] == ["other"]
    assert found.lost("/talk") == 3
    view = found.topic("/talk")
    assert (view.times, view.lost, view.watched) == ((1.0, 1.3), 3, 3.0)


def test_what_came_of_each_message_of_the_arena() -> None:
    found = record(
        log(0.9, "talker", "early"),
        MessageSent(1.0, "/ask", STRING, HELLO),
        OutputLine(1.0, "talker", "printed at once"),
        log(1.1, "talker", "one"),
        MessageSeen(1.2, "/answer", STRING, HELLO),
        log(1.3, "talker", "more"),
        MessageSent(2.0, "/ask", STRING, HELLO),
        MessageSent(2.5, "/other", STRING, HELLO),
        OutputLine(2.6, "other", "no"),
        log(2.7, "talker", "two"),
    )
    first, second = found.reactions("/ask")
    assert (first.to.t, first.until, second.to.t) == (1.0, 2.0, 2.0)
    assert (first.logged, second.logged) == ("one\nmore", "two")
    assert [len(one.topic("/answer").messages) for one in (first, second)] == [1, 0]
    assert (first.printed("talker"), second.printed("talker")) == (("printed at once",), ())
    assert found.reactions("/never") == ()


def test_what_a_flood_overruns_was_not_lost_by_us() -> None:
    """More at once than the sender's own queue holds; a few that come slowly are another matter."""
    burst = [MessageSeen(1.0 + number / 1000, "/talk", STRING, HELLO) for number in range(20)]
    assert record(*burst, MessagesLost(1.01, "/talk", 2)).lost("/talk") == 0
    assert record(*burst, MessagesLost(2.0, "/talk", 2)).lost("/talk") == 2
    assert record(*burst[:3], MessagesLost(1.01, "/talk", 400)).lost("/talk") == 0


def test_messages_are_decoded_once() -> None:
    found = record(MessageSeen(1.0, "/talk", STRING, HELLO))
    assert found.messages("/talk") is found.messages("/talk")


def test_the_log_has_the_levels_of_its_lines() -> None:
    found = record(log(1.0, "talker", "one"), log(2.0, "listener", "two"), log(3.0, "talker", "drei", 30))
    assert [(line.t, line.level, line.text) for line in found.log if line.node == "talker"] == [
        (1.0, "INFO", "one"),
        (3.0, "WARN", "drei"),
    ]
    assert len(found.log) == 3


def endpoint(node: str, topic: str = "/talk", qos: Qos | None = None) -> Endpoint:
    return Endpoint(topic, "publisher", node, STRING, "RIHS01_1", qos or Qos())


def test_an_endpoint_without_a_name_is_the_one_that_gets_it() -> None:
    found = record(
        GraphSeen(1.0, Graph(endpoints=(endpoint(""),))),
        GraphSeen(2.0, Graph(("/talker",), (endpoint("/talker"),))),
        GraphSeen(3.0, Graph()),
    )
    assert found.seen_endpoints() == (endpoint("/talker"),)
    assert found.seen_nodes() == ("/talker",)


def test_an_endpoint_that_never_gets_a_name_counts_too() -> None:
    found = record(GraphSeen(1.0, Graph(endpoints=(endpoint(""), endpoint("/talker", "/other")))))
    assert found.seen_endpoints() == (endpoint("/talker", "/other"), endpoint(""))


def test_endpoints_of_one_topic_are_kept_apart() -> None:
    two = (endpoint("/a"), endpoint("/b"), endpoint("/b", qos=Qos("best_effort")))
    assert set(record(GraphSeen(1.0, Graph(endpoints=two))).seen_endpoints()) == set(two)


def test_everything_that_was_ever_there_in_one_graph() -> None:
    first, later = Service("/add", "a/srv/B"), Service("/add", "a/srv/B", "1", "2")
    found = record(
        GraphSeen(1.0, Graph(("/b",), (), (first,))), GraphSeen(2.0, Graph(("/a",), (), (later,)))
    ).seen_graph()
    assert (found.nodes, found.services) == (("/a", "/b"), (first, later))


def test_marks_files_and_missing_executables() -> None:
    missing = ExecutableMissing(1.0, "it", "talk", "talker", ())
    found = record(missing, FileKept(1.0, "a", "text"), FileKept(1.0, "b", None), Marked(2.0, "done", "well"))
    assert found.missing_executable("it") == missing
    assert found.missing_executable("talker") is None
    assert (found.kept("a"), found.kept("b"), found.kept("c")) == ("text", None, None)
    assert found.marked("done") == Marked(2.0, "done", "well")
    assert found.marked("other") is None


@pytest.mark.parametrize(
    ("event", "said"),
    [
        (ProcessExited(2.0, "it", None, signal.SIGTERM), False),
        (ProcessExited(2.0, "other", None, signal.SIGKILL), True),
        (SignalSent(1.0, "it", signal.SIGINT), True),
        (SignalSent(1.0, "it", signal.SIGKILL), False),  # by us: it would not end
        (LimitReached(1.0, "memory", 1024.0), False),
    ],
)
def test_killed_means_not_by_us(event: Event, said: bool) -> None:
    ended = ProcessExited(2.0, "it", None, signal.SIGKILL)
    events = [event] if isinstance(event, ProcessExited) else [event, ended]
    assert bool(record(*events).killed) is said


def test_recordings_are_equal_by_what_they_hold(recording: Recording) -> None:
    assert len(recording.log) == 0  # a question asked before changes nothing
    assert recording == replace(recording)
    assert recording != replace(recording, duration=9.0)

"""A node that calls a service of the arena's again and again, and logs what it is answered."""

from __future__ import annotations

from math import inf

import pytest

from course.errors import OurFault
from course.evidence.events import Event, OutputLine, ProcessExited, ServiceAnswered, ServiceCalled
from course.evidence.recording import Recording
from course.evidence.service_view import ServiceCall
from course.grading.expect.callers import (
    expect_answers_logged,
    expect_calls,
    expect_patience,
    expect_waiting,
)

from .conftest import STARTED, log, record, said, told, where

NAME, TYPE = "/point", "words/srv/Point"
TICK = "create_timer(0.5, self.tick)\ndef tick(self):\n    {}\n"
SYNC = TICK.format("self.client.call(request)")
ASYNC = TICK.format("self.future = self.client.call_async(request)")
PARTS = {"x": "4711", "y": "1234"}


def asked(t: float, number: int, answer: float | None) -> tuple[Event, ...]:
    call = ServiceCalled(t, NAME, TYPE, "server", f"1.{number}", "/talker", b"\0\1\0\0")
    if answer is None:
        return (call,)
    return call, ServiceAnswered(answer, NAME, TYPE, "server", f"1.{number}", b"\0\1\0\0")


def ran(*events: Event, code: str = ASYNC) -> Recording:
    return record(STARTED, *events, code=code)


def texts(call: ServiceCall) -> dict[str, str]:
    return PARTS


# waiting


def test_a_node_that_says_that_it_waits() -> None:
    assert said(expect_waiting, ran(log(1.0, "no service yet")), "talker", 2.0) is None


@pytest.mark.parametrize(
    ("event", "code", "words", "lines"),
    [
        (
            log(3.0, "too late"),
            "\nself.create_client(T, 'x')",
            "`while not self.client.wait_for_service",
            [2],
        ),
        (log(3.0, "too late"), "\nwait_for_service()", "Log it before each `wait_for_service`", [2]),
        (OutputLine(1.0, "talker", "waiting"), "wait_for_service()", "Log it", [1]),
    ],
)
def test_a_node_that_waits_in_silence(event: Event, code: str, words: str, lines: list[int]) -> None:
    found = told(expect_waiting, ran(event, code=code), "talker", 2.0)
    assert words in str(found.advice)
    assert where(found) == [f"talk/talker.py:{line}" for line in lines]
    assert ("print" in found.summary) is isinstance(event, OutputLine)


# calling


def test_enough_calls() -> None:
    recording = ran(*asked(1.0, 0, 1.1), *asked(1.5, 1, 1.6))
    assert said(expect_calls, recording, "talker", NAME, at_least=2, period=0.5, since=0.5) is None


@pytest.mark.parametrize(
    ("count", "code", "summary", "words"),
    [
        (0, "", "The service is there, but the node does not call it.", "No timer is made"),
        (1, SYNC, "The node calls the service once, and then no more.", "a deadlock"),
        (2, ASYNC, "The node calls the service 2 times, and then no more.", "each time"),
    ],
)
def test_too_few_calls(count: int, code: str, summary: str, words: str) -> None:
    events = [event for n in range(count) for event in asked(1.0 + n, n, 1.1 + n)]
    found = told(expect_calls, ran(*events, code=code), "talker", NAME, at_least=5, period=0.5, since=1.0)
    assert found.summary == summary
    assert words in str(found.advice)
    assert found.seen == f"{count} calls in 8.0 s"


def test_a_program_that_ended_did_not_just_stop_calling() -> None:
    ended = ProcessExited(2.0, "talker", 0, None)
    found = told(expect_calls, ran(ended), "talker", NAME, at_least=5, period=0.5, since=1.0)
    assert "ended by itself" in found.summary


# logging


def answered(*events: Event, code: str = ASYNC) -> Recording:
    return ran(*asked(1.0, 0, 1.1), *events, code=code)


def judged(recording: Recording) -> object:
    return said(expect_answers_logged, recording, "talker", recording.service(NAME).requests, texts)


@pytest.mark.parametrize(
    "lines", [("(4711.0, 1234.0)",), ("x: 4711", "other", "y: 1234.00")], ids=["one line", "more lines"]
)
def test_all_parts_are_logged(lines: tuple[str, ...]) -> None:
    assert judged(answered(*(log(1.2 + n, text) for n, text in enumerate(lines)))) is None


@pytest.mark.parametrize(
    ("events", "code", "words"),
    [
        ((log(1.2, "x=4711"),), ASYNC, "`y` is missing"),
        ((log(0.5, "4711 1234"),), ASYNC, "once the future is `done()`"),
        ((log(1.2, "{point.x}"),), ASYNC, "put an `f` before"),
        ((OutputLine(1.2, "talker", "4711 1234"),), "print(point)", "in place of `print`"),
        ((), TICK.format("self.client.call_async(request)"), "add_done_callback"),
    ],
)
def test_parts_that_are_missing(events: tuple[Event, ...], code: str, words: str) -> None:
    found = judged(answered(*events, code=code))
    assert words in str(getattr(found, "advice", None))


# patience


def test_it_asks_and_logs_again() -> None:
    recording = ran(*asked(1.0, 0, None), *asked(3.0, 1, 3.1), log(3.2, "4711 1234"))
    assert said(expect_patience, recording, "talker", NAME, 2.0, 0.5, texts) is None


@pytest.mark.parametrize(
    ("events", "code", "words"),
    [
        ((), ASYNC, "never called again"),
        (asked(3.0, 1, 3.1), ASYNC, "logs no later one"),
        ((), SYNC, "never called again"),
    ],
)
def test_it_does_not_go_on(events: tuple[Event, ...], code: str, words: str) -> None:
    recording = ran(*asked(1.0, 0, None), *events, code=code)
    found = told(expect_patience, recording, "talker", NAME, 2.0, 0.5, texts)
    assert words in found.summary
    assert ("deadlock" if code == SYNC else "`cancel()`") in str(found.advice)


def test_a_silence_that_never_was_is_our_fault() -> None:
    with pytest.raises(OurFault):
        expect_patience(ran(), "talker", NAME, inf, 0.5, texts)

"""A node that calls a service of the arena again and again, and logs the answers."""

from __future__ import annotations

from math import inf

import pytest

from course.errors import OurFault
from course.evidence.recording import Recording
from course.evidence.service_view import ServiceCall
from course.evidence.sources import Sources
from course.explain.engine import Cause
from course.model.events import Event, OutputLine, ProcessExited, ServiceAnswered, ServiceCalled
from lib.callers import (
    expect_answers_logged,
    expect_calls,
    expect_patience,
    expect_waiting,
    future_lost,
    no_wait,
)
from tests.golden import golden
from tests.grading.expect.conftest import STARTED, log, record, said, told

NAME, TYPE = "/point", "words/srv/Point"
TICK = "create_timer(0.5, self.tick)\ndef tick(self):\n    {}\n"
SYNC = TICK.format("self.client.call(request)")
ASYNC = TICK.format("self.future = self.client.call_async(request)")
DEF = "def tick(self):\n"
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
    ("event", "code"),
    [
        (log(3.0, "too late"), "\nself.create_client(T, 'x')"),
        (log(3.0, "too late"), "\nwait_for_service()"),
        (OutputLine(1.0, "talker", "waiting"), "wait_for_service()"),
    ],
)
def test_a_node_that_waits_in_silence(event: Event, code: str) -> None:
    golden(told(expect_waiting, ran(event, code=code), "talker", 2.0))


# calling


def test_enough_calls() -> None:
    recording = ran(*asked(1.0, 0, 1.1), *asked(1.5, 1, 1.6))
    assert said(expect_calls, recording, "talker", NAME, at_least=2, period=0.5, since=0.5) is None


@pytest.mark.parametrize(("count", "code"), [(0, ""), (1, SYNC), (2, ASYNC)])
def test_too_few_calls(count: int, code: str) -> None:
    events = [event for n in range(count) for event in asked(1.0 + n, n, 1.1 + n)]
    golden(told(expect_calls, ran(*events, code=code), "talker", NAME, at_least=5, period=0.5, since=1.0))


def test_a_program_that_ended_did_not_just_stop_calling() -> None:
    ended = ProcessExited(2.0, "talker", 0, None)
    golden(told(expect_calls, ran(ended), "talker", NAME, at_least=5, period=0.5, since=1.0))


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
        ((log(1.2, "{point.x}"),), ASYNC, "Put an `f` before"),
        ((OutputLine(1.2, "talker", "4711 1234"),), "print(point)", "instead of `print`"),
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


@pytest.mark.parametrize(("events", "code"), [((), ASYNC), (asked(3.0, 1, 3.1), ASYNC), ((), SYNC)])
def test_it_does_not_go_on(events: tuple[Event, ...], code: str) -> None:
    recording = ran(*asked(1.0, 0, None), *events, code=code)
    golden(told(expect_patience, recording, "talker", NAME, 2.0, 0.5, texts))


def test_a_silence_that_never_was_is_our_fault() -> None:
    with pytest.raises(OurFault):
        expect_patience(ran(), "talker", NAME, inf, 0.5, texts)


# Causes in the code


def sources(text: str) -> Sources:
    return Sources({"talker.py": text})


def at(cause: Cause | None) -> list[str]:
    return [str(place).removeprefix("talker.py:") for place in cause.where]


def test_a_future_that_is_lost() -> None:
    assert at(future_lost(sources(f"{DEF}    self.client.call_async(request)\n"))) == ["2"]
    for kept in ("self.future = ", "return ", "await "):
        assert future_lost(sources(f"async {DEF}    {kept}c.call_async(r)\n")) is None
    chained = "    c.call_async(r).add_done_callback(self.answered)\n"
    assert future_lost(sources(DEF + chained)) is None


def test_code_that_never_waits() -> None:
    assert at(no_wait(sources("\nself.create_client(T, 'x')"))) == ["2"]
    assert no_wait(sources("self.client.wait_for_service()")) is None
    assert no_wait(sources("if self.client.service_is_ready(): pass")) is None

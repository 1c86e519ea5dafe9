"""Calls of a service, put together from their two halves."""

from __future__ import annotations

from course.evidence.recording import Recording
from course.model.events import Event, ServiceAnswered, ServiceCalled, Side

from .conftest import HELLO

SAY = "talk/srv/Say"
DEFINITIONS = {f"{SAY}_Request": "string data", f"{SAY}_Response": "string data"}
OTHER = HELLO.replace(b"hello", b"other")


def called(t: float, call: str, side: Side = "client", service: str = "/say") -> ServiceCalled:
    return ServiceCalled(t, service, SAY, side, call, f"of {call}", HELLO)


def answered(t: float, call: str, side: Side = "client", service: str = "/say") -> ServiceAnswered:
    return ServiceAnswered(t, service, SAY, side, call, OTHER)


def record(*events: Event) -> Recording:
    return Recording("x", events, DEFINITIONS)


def test_a_call_and_its_answer() -> None:
    (call,) = record(called(1.0, "1.0"), answered(1.25, "1.0")).service("/say").calls
    assert (call.asked, call.answered, call.duration, call.client) == (1.0, 1.25, 0.25, "of 1.0")
    assert (call.request.data, call.response.data) == ("hello", "other")


def test_answers_find_their_calls_in_any_order() -> None:
    view = record(
        called(1.0, "1.0"), called(1.1, "2.0"), called(1.2, "1.1"), answered(1.3, "1.1"), answered(1.4, "1.0")
    ).service("/say")
    assert [(c.asked, c.answered) for c in view.calls] == [(1.0, 1.4), (1.1, None), (1.2, 1.3)]
    assert [c.asked for c in view.answered] == [1.0, 1.2]
    unanswered = [c for c in view.calls if c.answered is None]
    assert [(c.asked, c.response, c.duration) for c in unanswered] == [(1.1, None, None)]


def test_the_arena_s_calls_and_those_that_reached_its_server_are_kept_apart() -> None:
    view = record(
        called(1.0, "1.0"),
        called(2.0, "2.1", "server"),
        answered(2.1, "2.1", "server"),
        called(3.0, "3.1", "server", "/other"),
    ).service("/say")
    assert [call.asked for call in view.calls] == [1.0]
    assert [(call.asked, call.answered) for call in view.requests] == [(2.0, 2.1)]


def test_an_answer_that_cannot_be_read_is_an_answer() -> None:
    garbage = ServiceAnswered(1.5, "/say", SAY, "client", "1.0", b"")
    (call,) = record(called(1.0, "1.0"), garbage).service("/say").calls
    assert call.answered == 1.5
    assert call.response is not None
    assert not call.response


def test_a_service_that_nobody_called() -> None:
    view = record().service("/say")
    assert (view.calls, view.requests) == ((), ())

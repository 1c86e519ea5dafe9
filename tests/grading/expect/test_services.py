"""Services that a learner's nodes should offer and use, and what they should answer."""

from __future__ import annotations

import pytest

from course.errors import OurFault
from course.evidence.recording import Recording
from course.grading.expect.services import (
    expect_answers,
    expect_service,
    expect_service_type,
)
from course.model.events import Event, GraphSeen, ServiceAnswered, ServiceCalled, Side
from course.model.graph import Graph, Service
from tests.golden import golden

from .conftest import record, said, told

NAME = "/what_is_the_point"
TYPE = "words/srv/Point"
HASHES = ("RIHS01_1", "RIHS01_2")
CODE = "\nself.create_service(Point, '{0}', f)\nself.create_client(Point, '{0}')\n"
SLEEPER = (
    "self.create_service(Point, '/x', self.answer)\n"
    "def answer(self, request, response):\n    time.sleep(2)\n    return response\n"
)


def of(side: Side, name: str = NAME, type_name: str = TYPE) -> Service:
    if side == "server":
        return Service(name, type_name, *HASHES, servers=("/talker",))
    return Service(name, type_name, clients=("/talker",))


def seen(*services: Service, code: str = "") -> Recording:
    return record(GraphSeen(1.0, Graph(services=services)), GraphSeen(2.0, Graph()), code=code)


def called(t: float, answer: float | None, number: int = 0) -> tuple[Event, ...]:
    asked = ServiceCalled(t, NAME, TYPE, "client", f"1.{number}", "client 1", b"\0\1\0\0")
    if answer is None:
        return (asked,)
    return asked, ServiceAnswered(answer, NAME, TYPE, "client", f"1.{number}", b"\0\1\0\0")


@pytest.mark.parametrize("side", ["server", "client"])
def test_a_service_that_was_there_once_is_enough(side: Side) -> None:
    assert said(expect_service, seen(of(side)), side, NAME, remedy="make one") is None


@pytest.mark.parametrize("side", ["server", "client"])
@pytest.mark.parametrize("slash", ["", "/"])
def test_a_misspelt_service(side: Side, slash: str) -> None:
    recording = seen(of(side, "/what_is_teh_point"), code=CODE.format(f"{slash}what_is_teh_point"))
    golden(told(expect_service, recording, side, NAME, remedy="make one"))


@pytest.mark.parametrize(("side", "other"), [("server", "client"), ("client", "server")])
def test_the_other_side_does_not_count(side: Side, other: Side) -> None:
    golden(told(expect_service, seen(of(other), code=CODE.format("x")), side, NAME, remedy="make one"))


@pytest.mark.parametrize("side", ["server", "client"])
def test_a_wrong_type(side: Side) -> None:
    recording = seen(of(side, type_name="std_srvs/srv/SetBool"), code=CODE.format("x"))
    golden(told(expect_service_type, recording, side, NAME, TYPE))
    assert said(expect_service_type, seen(of(side)), side, NAME, TYPE) is None


# answers


def test_all_calls_are_answered() -> None:
    calls = expect_answers(record(*called(1.0, 1.2), *called(1.1, 1.3, 1)), NAME)
    assert [call.asked for call in calls] == [1.0, 1.1]


def test_nothing_was_called() -> None:
    with pytest.raises(OurFault, match="point"):
        expect_answers(record(), NAME)


@pytest.mark.parametrize(
    "code",
    [
        "self.create_service(P, '/x', self.f)\ndef f(self, request, response):\n    pass\n",
        SLEEPER,
        "self.create_service(P, '/x', self.f)\ndef f(self, a, b):\n    return b\n",
    ],
)
def test_a_call_without_an_answer(code: str) -> None:
    golden(told(expect_answers, record(*called(1.0, None), *called(1.1, 1.2, 1), code=code), NAME))


def test_a_late_answer() -> None:
    golden(told(expect_answers, record(*called(1.0, 3.0), code=SLEEPER), NAME))
    assert said(expect_answers, record(*called(1.0, 3.0)), NAME, within=2.5) is None

"""Parameters that a learner's node should have."""

from __future__ import annotations

import pytest

from course.errors import OurFault
from course.evidence.parameter_view import ParameterData
from course.evidence.recording import Recording
from course.grading.expect.parameters import expect_declared, expect_parameter, expect_set
from course.model.events import Event, OutputLine
from tests.golden import golden

from . import conftest
from .conftest import record, said, told
from .parameter_calls import DEFINITIONS, NODE, Cdr, call, got, listed, set_to

CODE = """\
self.declare_parameter('period', '0.5')
self.declare_parameter('qoute', 'a')
self.get_parameter('period')
"""


@pytest.fixture(autouse=True)
def _definitions(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(conftest, "DEFINITIONS", DEFINITIONS)


def seen(*events: tuple[Event, ...]) -> Recording:
    return record(*(event for few in events for event in few), code=CODE)


@pytest.mark.parametrize("value", ["a", 0.5, 3, True])
def test_a_parameter_that_is_right(value: ParameterData) -> None:
    assert said(expect_parameter, seen(got(1.0, "quote", value)), NODE, "quote", value) is None


def test_the_value_at_a_time() -> None:
    recording = seen(got(1.0, "quote", "a"), got(2.0, "quote", "b"))
    assert said(expect_parameter, recording, NODE, "quote", "b") is None
    assert said(expect_parameter, recording, NODE, "quote", "a", t=1.5) is None
    golden(told(expect_parameter, recording, NODE, "quote", "a"))


def test_a_misspelt_parameter() -> None:
    recording = seen(got(1.0, "quote", None), listed(1.1, "use_sim_time", "qoute", "period"))
    golden(told(expect_parameter, recording, NODE, "quote", "a"))


def test_an_undeclared_parameter() -> None:
    recording = seen(got(1.0, "topic_name", None), listed(1.1, "use_sim_time", "qoute", "period"))
    golden(told(expect_declared, recording, NODE, "topic_name", "talk"))


def test_the_exception_that_says_so_is_shown() -> None:
    error = "rclpy.exceptions.ParameterNotDeclaredException: Invalid access to undeclared parameter(s): x"
    line = (OutputLine(1.5, "talker", error),)
    golden(told(expect_declared, seen(got(1.0, "x", None), line), NODE, "x", 1))


def test_a_wrong_type() -> None:
    golden(told(expect_parameter, seen(got(1.0, "period", "0.5")), NODE, "period", 0.5))


def test_an_integer_is_no_double() -> None:
    golden(told(expect_parameter, seen(got(1.0, "period", 1)), NODE, "period", 1.0))


def test_a_node_that_does_not_answer() -> None:
    asked = call(1.0, "list_parameters", "ListParameters", Cdr(), None)
    assert "does not answer" in told(expect_declared, seen(asked), NODE, "x", 1).summary


@pytest.mark.parametrize("expect", [expect_declared, expect_parameter])
def test_what_was_never_asked_is_our_fault(expect: object) -> None:
    with pytest.raises(OurFault):
        expect(seen(), NODE, "x", 1)  # type: ignore[operator]
    with pytest.raises(OurFault):
        expect_set(seen(got(1.0, "quote", "a")), NODE, "quote")


@pytest.mark.parametrize("answer", ["too short", None])
def test_setting(answer: str | None) -> None:
    recording = seen(got(0.5, "quote", "a"), set_to(1.0, "quote", "b", answer))
    golden(told(expect_set, recording, NODE, "quote"))
    taken = seen(set_to(1.0, "quote", "b", ""), set_to(2.0, "other", "b", "no"))
    assert said(expect_set, taken, NODE, "quote") is None

"""That a program starts, keeps running, and ends on Ctrl+C."""

from __future__ import annotations

import signal
from collections.abc import Callable
from typing import Any

import pytest

from course.errors import OurFault
from course.evidence.recording import Recording
from course.grading.expect.programs import (
    expect_clean_end,
    expect_clean_interrupt,
    expect_executable,
    expect_running,
)
from course.model.events import Event, ExecutableMissing, OutputLine, ProcessExited, SignalSent
from course.model.feedback import DoubtfulFailure, Failure, Spoilt
from tests.golden import golden

from .conftest import STARTED, record, said, told

MISSING = ExecutableMissing(0.1, "talker", "talk", "talker", ())
INTERRUPTED = SignalSent(5.0, "talker", signal.SIGINT)
TRACEBACK = """\
Traceback (most recent call last):
  File "/store/talk/lib/python3.12/site-packages/talk/talker.py", line 2, in main
    rclpy.spin(node)
{}"""
IN_RCLPY = """\
Traceback (most recent call last):
  File "/store/talk/lib/python3.12/site-packages/talk/talker.py", line 2, in main
    rclpy.spin(node)
  File "/opt/ros/jazzy/lib/python3.12/site-packages/rclpy/executors.py", line 709, in _wait
    wait_set = _rclpy.WaitSet(
{}"""
SHUT_DOWN_TWICE = """\
Traceback (most recent call last):
  File "/store/talk/lib/python3.12/site-packages/talk/talker.py", line 2, in main
    rclpy.{called}()
  File "/opt/ros/jazzy/lib/python3.12/site-packages/rclpy/__init__.py", line 130, in {called}
    _shutdown(context=context)
  File "/opt/ros/jazzy/lib/python3.12/site-packages/rclpy/context.py", line 139, in {called}
    self.__context.shutdown()
rclpy._rclpy_pybind11.RCLError: failed to shutdown: rcl_shutdown already called on the given context, at \
/src/rcl/init.c:333"""
CRASH = TRACEBACK.format("ValueError: x")
BREAK = TRACEBACK.format("KeyboardInterrupt")


def end(t: float, code: int | None = 0, number: int | None = None) -> ProcessExited:
    return ProcessExited(t, "talker", code, number)


def printed(t: float, text: str) -> list[Event]:
    return [OutputLine(t, "talker", line) for line in text.splitlines()]


def ran(*events: Event, code: str = "\nrclpy.spin(node)") -> Recording:
    return record(STARTED, *events, code=code)


@pytest.mark.parametrize(
    "expect", [expect_executable, expect_running, expect_clean_end, expect_clean_interrupt]
)
def test_a_missing_executable_is_told_by_all(expect: Callable[..., Any]) -> None:
    assert "No executable found" in told(expect, record(MISSING), "talker").summary


@pytest.mark.parametrize(
    "expect", [expect_executable, expect_running, expect_clean_end, expect_clean_interrupt]
)
def test_a_program_that_the_scenario_never_ran_passes_nowhere(expect: Callable[..., Any]) -> None:
    """For example, if scenario and check use different names: our error."""
    with pytest.raises(OurFault, match="taker"):
        expect(ran(), "taker")


# running


def test_running_until_we_ended_it() -> None:
    assert said(expect_running, ran(), "talker") is None
    assert said(expect_running, ran(INTERRUPTED, end(5.1)), "talker") is None
    assert said(expect_running, ran(SignalSent(5.0, "talker", 9), end(5.1, None, 9)), "talker") is None


def test_ended_by_itself() -> None:
    golden(told(expect_running, ran(*printed(1.0, "one\ntwo"), end(1.6)), "talker"))


def test_ended_after_the_time_that_counts() -> None:
    assert said(expect_running, ran(end(2.0)), "talker", until=2.0) is None
    assert said(expect_running, ran(end(1.9)), "talker", until=2.0) is not None


@pytest.mark.parametrize("number", [9, 11, 35, 63])
def test_ended_by_a_signal(number: int) -> None:
    golden(told(expect_running, ran(end(1.0, None, number)), "talker"))


def test_crashed() -> None:
    golden(told(expect_running, ran(*printed(1.0, CRASH), end(1.1, 1)), "talker"))


@pytest.mark.parametrize(
    "code",
    [
        "print('x')",
        "rclpy.init()\nrclpy.spin(node)",
        "rclpy.init()\nrclpy.spin_once(node)",
        "rclpy.init()\nnode = Node('x')",
    ],
)
def test_advice_to_keep_it_running(code: str) -> None:
    golden(told(expect_running, ran(end(1.0), code=code), "talker"))


# ending by itself


def test_a_clean_end() -> None:
    assert said(expect_clean_end, ran(end(1.0)), "talker") is None


def test_an_error_that_was_caught_and_shown_is_no_crash() -> None:
    assert said(expect_clean_end, ran(*printed(1.0, CRASH), end(1.1)), "talker") is None


@pytest.mark.parametrize(
    "events",
    [
        [end(1.0, 3)],
        [end(1.0, None, 15)],
        [INTERRUPTED, end(5.1)],
        [SignalSent(5.0, "talker", 9), end(5.1, None, 9)],
        [],
    ],
)
def test_another_end(events: list[Event]) -> None:
    golden(told(expect_clean_end, ran(*printed(0.5, "hello"), *events), "talker"))


def test_why_there_was_no_clean_end() -> None:
    golden(told(expect_clean_end, ran(end(1.0, 1)), "talker"))
    golden(
        told(
            expect_clean_end,
            ran(*printed(1.0, "round"), INTERRUPTED, *printed(5.1, "^C"), end(5.2)),
            "talker",
        )
    )


def test_a_crash_in_place_of_an_end() -> None:
    golden(told(expect_clean_end, ran(*printed(1.0, CRASH), end(1.1, 1)), "talker"))


# Ctrl+C


@pytest.mark.parametrize("ended", [end(5.1, 0), end(5.1, 1), end(5.1, 130), end(5.1, None, 2)])
def test_a_quiet_end(ended: ProcessExited) -> None:
    assert said(expect_clean_interrupt, ran(INTERRUPTED, ended), "talker") is None


def test_a_traceback_before_ctrl_c_is_no_matter_of_it() -> None:
    assert said(expect_clean_interrupt, ran(*printed(1.0, CRASH), INTERRUPTED, end(5.1)), "talker") is None


@pytest.mark.parametrize(
    "error",
    [
        "rclpy._rclpy_pybind11.RCLError: failed to initialize wait set: the given context is not valid, "
        "either rcl_init() was not called or rcl_shutdown() was called., at /src/rcl/wait.c:130",
        "SystemError: <built-in method take_response of pybind11_builtins.pybind11_detail_function_record_v1 "
        "object at 0x7f9398ce9cb0> returned a result with an exception set",
        "RuntimeError: Unable to convert call argument '0' to Python object (#define "
        "PYBIND11_DETAILED_ERROR_MESSAGES or compile in debug mode for details)",
        "AttributeError: 'Task' object has no attribute '_exception'",
    ],
)
def test_what_rclpy_stumbles_over_is_nobody_s_failure(error: str) -> None:
    lines = printed(5.1, IN_RCLPY.format(error))
    with pytest.raises(Spoilt, match="while it shut down"):
        expect_clean_interrupt(ran(INTERRUPTED, *lines, end(5.2, 1)), "talker")
    lines = printed(5.1, TRACEBACK.format(error))  # raised in the learner's own file
    golden(told(expect_clean_interrupt, ran(INTERRUPTED, *lines, end(5.2, 1)), "talker"))


@pytest.mark.parametrize("called", ["try_shutdown", "shutdown"])
def test_only_try_shutdown_may_come_too_late(called: str) -> None:
    """What it found running, the thread that handles Ctrl+C may shut down before it does."""
    recording = ran(INTERRUPTED, *printed(5.1, SHUT_DOWN_TWICE.format(called=called)), end(5.2, 1))
    if called == "try_shutdown":
        with pytest.raises(Spoilt, match="while it shut down"):
            expect_clean_interrupt(recording, "talker")
    else:
        golden(told(expect_clean_interrupt, recording, "talker"))


def test_a_traceback_after_ctrl_c() -> None:
    golden(told(expect_clean_interrupt, ran(INTERRUPTED, *printed(5.1, BREAK), end(5.2, 1)), "talker"))


@pytest.mark.parametrize("events", [[], [SignalSent(8.0, "talker", 9), end(8.1, None, 9)]])
def test_deaf(events: list[Event]) -> None:
    recording = ran(INTERRUPTED, *events, code="\nsignal.signal(signal.SIGINT, signal.SIG_IGN)")
    golden(told(expect_clean_interrupt, recording, "talker"))


@pytest.mark.parametrize(
    ("code", "line"),
    [
        ("\nsignal.signal(signal.SIGINT, signal.SIG_IGN)", 2),
        ("while True:\n    try:\n        spin()\n    except KeyboardInterrupt:\n        pass", 1),
        ("while waiting:\n    rest()", None),
    ],
)
def test_deaf_for_no_reason_that_its_code_shows(code: str, line: int | None) -> None:
    """ROS itself may hang: then another attempt decides."""
    with pytest.raises(Failure) as failure:
        expect_clean_interrupt(ran(INTERRUPTED, code=code), "talker")
    assert [place.line for place in failure.value.feedback.where] == ([line] if line else [])
    assert isinstance(failure.value, DoubtfulFailure) is (line is None)


def test_another_exit_code() -> None:
    golden(told(expect_clean_interrupt, ran(INTERRUPTED, end(5.1, 7)), "talker"))


def test_ended_before_it_could_be_tried() -> None:
    golden(told(expect_clean_interrupt, ran(end(1.0)), "talker"))

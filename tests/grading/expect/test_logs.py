"""What a node should log, and where its words went instead."""

from __future__ import annotations

import pytest

from course.evidence.recording import Recording
from course.grading.expect.logs import expect_logged
from course.model.events import OutputLine
from course.model.feedback import Feedback
from tests.golden import golden

from .conftest import log, record, said, told, where

EXAMPLE = "Printed 0 times."


def judged(recording: Recording) -> Feedback | None:
    lines = tuple(line for line in recording.log if "Printed" in line.text)
    return said(expect_logged, recording, "talker", lines, EXAMPLE, "Print")


def feedback(recording: Recording) -> Feedback:
    found = judged(recording)
    assert found is not None
    return found


def test_lines_at_info() -> None:
    assert judged(record(log(1.0, "Printed 0 times."), log(1.5, "Printed 1 times."))) is None
    assert judged(record(log(0.5, "hello", 30), log(1.0, "Printed 0 times."))) is None


@pytest.mark.parametrize(
    ("level", "method"), [(10, "debug"), (30, "warn"), (30, "warning"), (40, "error"), (50, "fatal")]
)
def test_another_level(level: int, method: str) -> None:
    golden(feedback(record(log(1.0, EXAMPLE, level), code=f"x\nself.get_logger().{method}('x')")))


def test_one_line_at_another_level_is_enough() -> None:
    assert "ERROR" in feedback(record(log(1.0, EXAMPLE), log(2.0, "Printed 1 times.", 40))).summary


def test_other_words() -> None:
    lines = [log(t, "Count: 0") for t in (1.0, 1.5, 2.0)]
    golden(feedback(record(*lines, code="\nlog.info(f'Count: {n}')\n# Count: 0")))


def test_a_greeting_alone_does_not_mean_that_the_words_differ() -> None:
    code = "class Talker(Node):\n    def __init__(self):\n        self.get_logger().info('Ready')\n"
    found = feedback(record(log(1.0, "Ready"), code=code))
    assert "nothing like" in found.summary
    assert "creates no timer" in str(found.advice)


def test_braces_as_they_stand() -> None:
    golden(feedback(record(log(1.0, "Print {n} times."), code="\nlog.info('Print {n} times.')")))


@pytest.mark.parametrize("text", ["", " "])
def test_an_empty_text_is_nowhere(text: str) -> None:
    assert where(feedback(record(log(1.0, text), code="a b\nc d"))) == []


def test_long_words_are_cut() -> None:
    found = feedback(record(log(1.0, "x" * 1000)))
    assert len(found.summary) < 200
    assert len(str(found.seen)) <= 200


def test_printed_and_not_logged() -> None:
    golden(feedback(record(OutputLine(1.0, "talker", EXAMPLE), code="\nprint('x')\nprint('y')")))


def test_of_another_logger() -> None:
    line = OutputLine(1.0, "talker", f"[INFO] [1795810087.158] [forever]: {EXAMPLE}")
    golden(feedback(record(line, code="\nprint('x')\nlogging.get_logger('forever').info(x)")))


def test_what_another_program_prints_does_not_count() -> None:
    golden(feedback(record(OutputLine(1.0, "other", EXAMPLE), OutputLine(1.0, "talker", "ready"))))


def test_silent_below_info() -> None:
    golden(feedback(record(code="\nself.get_logger().debug('x')")))


@pytest.mark.parametrize(
    "code",
    [
        "",
        "self.create_timer(500, self.tick)",
        "self.create_timer(0.5, self.tick)\nrclpy.spin(node)",
        "self.create_timer(0.5, self.tick)",
    ],
)
def test_silent(code: str) -> None:
    golden(told(expect_logged, record(code=code), "talker", (), EXAMPLE, "Print"))

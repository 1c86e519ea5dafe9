"""What a node should log, and where its words went astray."""

from __future__ import annotations

import pytest

from course.evidence.events import OutputLine
from course.evidence.recording import Recording
from course.feedback import Feedback
from course.grading.expect.logs import expect_logged

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
    ("level", "name", "method"),
    [
        (10, "DEBUG", "debug"),
        (30, "WARN", "warn"),
        (30, "WARN", "warning"),
        (40, "ERROR", "error"),
        (50, "FATAL", "fatal"),
    ],
)
def test_another_level(level: int, name: str, method: str) -> None:
    found = feedback(record(log(1.0, EXAMPLE, level), code=f"x\nself.get_logger().{method}('x')"))
    assert found.summary == f"The message is logged at level {name}, not INFO."
    assert found.seen == f"[{name}] {EXAMPLE}"
    assert where(found) == ["talk/talker.py:2"]


def test_one_line_at_another_level_is_enough() -> None:
    assert "ERROR" in feedback(record(log(1.0, EXAMPLE), log(2.0, "Printed 1 times.", 40))).summary


def test_other_words() -> None:
    found = feedback(record(log(1.0, "Count: 0"), code="\nlog.info(f'Count: {n}')\n# Count: 0"))
    assert found.summary == "The node logs other words: `Count: 0`."
    assert (found.expected, found.seen) == (EXAMPLE, "Count: 0")
    assert "full stop" in str(found.advice)


def test_braces_as_they_stand() -> None:
    found = feedback(record(log(1.0, "Print {n} times."), code="\nlog.info('Print {n} times.')"))
    assert "`f'...'`" in str(found.advice)
    assert where(found) == ["talk/talker.py:2"]


@pytest.mark.parametrize("text", ["", " "])
def test_an_empty_text_is_nowhere(text: str) -> None:
    assert where(feedback(record(log(1.0, text), code="a b\nc d"))) == []


def test_long_words_are_cut() -> None:
    found = feedback(record(log(1.0, "x" * 1000)))
    assert len(found.summary) < 200
    assert len(str(found.seen)) <= 200


def test_printed_and_not_logged() -> None:
    found = feedback(record(OutputLine(1.0, "talker", EXAMPLE), code="\nprint('x')\nprint('y')"))
    assert "`print`" in found.summary
    assert found.seen == f"on the terminal only: {EXAMPLE}"
    assert where(found) == ["talk/talker.py:2", "talk/talker.py:3"]


def test_what_another_program_prints_does_not_count() -> None:
    found = feedback(record(OutputLine(1.0, "other", EXAMPLE), OutputLine(1.0, "talker", "ready")))
    assert found.summary == "The node runs, but it logs nothing."


def test_silent_below_info() -> None:
    found = feedback(record(code="\nself.get_logger().debug('x')"))
    assert "DEBUG" in found.summary
    assert where(found) == ["talk/talker.py:2"]


@pytest.mark.parametrize(
    ("code", "words"),
    [
        ("", "No timer is made anywhere"),
        ("self.create_timer(500, self.tick)", "in seconds"),
        ("self.create_timer(0.5, self.tick)\nrclpy.spin(node)", "something calls the callback"),
        ("self.create_timer(0.5, self.tick)", "hand the node to `rclpy.spin(node)`"),
    ],
)
def test_silent(code: str, words: str) -> None:
    found = told(expect_logged, record(code=code), "talker", (), EXAMPLE, "Print")
    assert (found.summary, found.seen) == ("The node runs, but it logs nothing.", "no message")
    assert words in str(found.advice)

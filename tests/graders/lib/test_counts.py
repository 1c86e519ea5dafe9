"""A node that logs how often something happened, in its own words."""

from __future__ import annotations

import re

import pytest

from course.evidence.recording import Recording
from course.model.events import OutputLine
from lib.counts import expect_counted, expect_counting, has_number
from tests.golden import golden
from tests.grading.expect.conftest import log, record, said, told

CODE = "\nself.get_logger().info(f'Call {n}')\n"


def counted(*texts: str, code: str = CODE) -> Recording:
    return record(*(log(1.0 + n, text) for n, text in enumerate(texts)), code=code)


@pytest.mark.parametrize(
    "words", ["Call {}", "{} calls.", "the {}th call", "No.{}", "#{}: x=3.25", "calls={}", "({})", "call\n{}"]
)
def test_the_words_do_not_matter(words: str) -> None:
    recording = counted(*(words.format(n) for n in (1, 2, 3)))
    assert said(expect_counted, recording, "talker", 3, what="calls") is None


def test_other_messages_in_between_do_not_matter() -> None:
    recording = counted("hello", "Call 1", "Point(x=7.0)", "Call 2", "again")
    assert said(expect_counted, recording, "talker", 2, what="calls") is None


def test_messages_that_two_threads_log_in_another_order() -> None:
    recording = counted("Call 1", "Call 2", "Call 4", "Call 3", "Call 7", "Call 5", "Call 6")
    assert said(expect_counted, recording, "talker", 7, what="calls") is None


def test_a_thread_that_logs_last() -> None:
    recording = counted(*(f"Call {n}" for n in (1, 2, 4, 5, 6, 7, 8, 9, 3)))
    assert said(expect_counted, recording, "talker", 9, what="calls") is None


def test_a_count_that_goes_down() -> None:
    recording = counted(*(f"Call {n}" for n in range(19, 0, -1)))
    assert said(expect_counted, recording, "talker", 19, what="calls") is not None


@pytest.mark.parametrize("text", ["13", "3.5", "0.3", "-3", "ember3", "3x", "2"])
def test_what_is_not_that_number(text: str) -> None:
    assert not has_number(f"a {text} b", 3)


@pytest.mark.parametrize(
    "texts", [("Call 0", "Call 1", "Call 2"), ("Call 1", "Call 1", "Call 1"), ("I was called",) * 3, ()]
)
def test_a_wrong_count(texts: tuple[str, ...]) -> None:
    golden(told(expect_counted, counted(*texts), "talker", 3, what="calls"))


def test_braces_that_are_logged() -> None:
    golden(told(expect_counted, counted("Call {n}"), "talker", 1, what="calls"))


def test_a_count_that_is_printed() -> None:
    golden(
        told(
            expect_counted,
            record(OutputLine(1.0, "talker", "Call 1"), code="print(n)"),
            "talker",
            1,
            what="calls",
        )
    )


@pytest.mark.parametrize(
    ("numbers", "summary", "advice"),
    [
        ((0, 1, 2, 3, 4, 5), None, None),
        ((1, 2, 3), "The first message is `Said 1 times.`, not `Said 0 times.`.", "begin"),
        ((0, 2, 4, 6, 8, 10), "The count does not go up by one: 0, 2, 4, 6, 8.", "step"),
        ((0, 0), "The count does not go up by one: 0, 0.", "step"),
        ((0, "9" * 5000), f"The count does not go up by one: 0, {'9' * 18}.", "step"),
    ],
)
def test_a_count_that_is_part_of_the_words(
    numbers: tuple[int | str, ...], summary: str | None, advice: str | None
) -> None:
    lines = counted(*(f"Said {n} times." for n in numbers)).log
    pattern = re.compile(r"Said (\d+) times")
    terminal = [f"[INFO] [1.0] [node]: {line.text}" for line in lines]
    code = "def say(self):\n    self.get_logger().info(f'Said {self.n} times.')\n"
    sources = counted(code=code).sources
    found = said(
        *(expect_counting, lines, pattern),
        **{"sources": sources, "terminal": terminal},
        **{"first": "Said 0 times.", "begin": "begin", "step": "step"},
    )
    assert (found and found.summary, found and found.advice) == (summary, advice)
    assert found is None or [place.line for place in found.where] == [2]


@pytest.mark.parametrize(
    ("shown", "summary"),
    [((0, 1, 2, 3, 4), None), ((2, 3, 4), "The first message is `Said 2 times.`, not `Said 0 times.`.")],
)
def test_messages_of_a_flood_that_never_reached_the_log(shown: tuple[int, ...], summary: str | None) -> None:
    lines = counted("Said 2 times.", "Said 4 times.").log
    terminal = [f"[INFO] [1.0] [node]: Said {n} times." for n in shown]
    found = said(
        expect_counting,
        lines,
        re.compile(r"Said (\d+) times"),
        sources=counted().sources,
        terminal=terminal,
        first="Said 0 times.",
        begin="begin",
        step="step",
    )
    assert (found and found.summary) == summary

"""The pipe that the verdict comes through."""

from __future__ import annotations

import json
import os
import threading
from collections.abc import Callable

import pytest

from course.feedback import Feedback, Location
from course.grading.channel import Channel, Judgement, read_message
from course.grading.result import CheckResult, Outcome

WAIT = 20.0
FEEDBACK = Feedback("it failed\nhere ✓", "a", "b", (Location("a.py", 1),), "try", ("x",))
CHECK = CheckResult("rate", "it is quick", 2, Outcome.FAILED, True, FEEDBACK)


def through_a_pipe(write: Callable[[Channel], None]) -> list[str | Judgement]:
    """What comes out at the other end; reading begins when the writer is busy already."""
    reader, writer = os.pipe()

    def send() -> None:
        write(Channel(writer))
        os.close(writer)

    thread = threading.Thread(target=send)
    thread.start()
    with os.fdopen(reader, encoding="utf-8") as stream:
        lines = list(stream)
    thread.join(WAIT)
    return [read_message(line) for line in lines]


@pytest.mark.parametrize("fault", [None, FEEDBACK])
def test_a_judgement_comes_out_as_it_went_in(fault: Feedback | None) -> None:
    judgement = Judgement((CHECK, CheckResult("x", "y", 1, Outcome.PASSED)), 1.25, fault, missing=bool(fault))
    assert through_a_pipe(lambda channel: channel.judgement(judgement)) == [judgement]


def test_more_than_a_pipe_holds() -> None:
    details = tuple(f"line {n} – {'x' * 100}" for n in range(20_000))
    judgement = Judgement(
        (CheckResult("x", "y", 1, Outcome.FAILED, feedback=Feedback("s", details=details)),), 1.0
    )
    assert through_a_pipe(lambda channel: channel.judgement(judgement)) == [judgement]


def test_messages_keep_their_order_and_stay_lines() -> None:
    def write(channel: Channel) -> None:
        channel.progress("one\ntwo")
        channel.progress("")
        channel.judgement(Judgement((), 0.0))

    assert through_a_pipe(write) == ["one\ntwo", "", Judgement((), 0.0)]


def test_a_reader_that_is_gone_is_noticed() -> None:
    reader, writer = os.pipe()
    os.close(reader)
    with pytest.raises(BrokenPipeError):
        Channel(writer).progress("hello")
    os.close(writer)


@pytest.mark.parametrize(
    "data",
    [
        None,
        5,
        [],
        {},
        {"kind": "progress"},
        {"kind": "judgement"},
        {"kind": "judgement", "checks": 5, "evidence": 1.0, "fault": None},
        {"kind": "judgement", "checks": [5], "evidence": 1.0, "fault": None},
        {"kind": "judgement", "checks": [{}], "evidence": 1.0, "fault": None},
        {"kind": "judgement", "checks": [], "evidence": 1.0, "fault": {"summary": "x"}},
    ],
)
def test_anything_else_is_refused(data: object) -> None:
    with pytest.raises(ValueError, match="no message"):
        read_message(json.dumps(data))


def test_a_line_cut_short_is_refused() -> None:
    with pytest.raises(ValueError, match="Expecting"):
        read_message('{"kind": ')

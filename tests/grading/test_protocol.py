"""The pipe for the outcome of a recording."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable

import pytest

from course.grading.protocol import RecordingOutcome, Stage, read_message, tell
from course.model.feedback import Feedback, Location
from course.model.result import Doubt

WAIT = 20.0
FEEDBACK = Feedback("it failed\nhere ✓", "a", "b", (Location("a.py", 1),), "try", ("x",))


def through_a_pipe(write: Callable[[int], None]) -> list[Stage | RecordingOutcome]:
    """What comes out at the other end; reading starts when the writer is already busy."""
    reader, writer = os.pipe()

    def send() -> None:
        write(writer)
        os.close(writer)

    thread = threading.Thread(target=send)
    thread.start()
    with os.fdopen(reader, "rb") as stream:
        lines = list(stream)
    thread.join(WAIT)
    return [read_message(line) for line in lines]


@pytest.mark.parametrize("fault", [None, FEEDBACK])
def test_an_outcome_comes_out_as_it_went_in(fault: Feedback | None) -> None:
    doubt = Doubt.SPOILT if fault else None
    outcome = RecordingOutcome(1.25, fault, doubt, 0.1, 0.2, missing=bool(fault))
    assert through_a_pipe(lambda pipe: tell(pipe, outcome)) == [outcome]


def test_more_than_a_pipe_holds() -> None:
    details = tuple(f"line {n} – {'x' * 100}" for n in range(20_000))
    outcome = RecordingOutcome(fault=Feedback("s", details=details))
    assert through_a_pipe(lambda pipe: tell(pipe, outcome)) == [outcome]


def test_messages_keep_their_order_and_stay_lines() -> None:
    messages = [Stage("one\ntwo"), Stage("", True), RecordingOutcome()]

    def write(pipe: int) -> None:
        for message in messages:
            tell(pipe, message)

    assert through_a_pipe(write) == messages


def test_a_reader_that_is_gone_is_noticed() -> None:
    reader, writer = os.pipe()
    os.close(reader)
    with pytest.raises(BrokenPipeError):
        tell(writer, Stage("hello"))
    os.close(writer)

"""Whether a program did anything after it received something."""

from __future__ import annotations

from math import inf

import pytest

from course.model.events import Event, OutputLine
from lib.deliveries import first_reaction
from tests.grading.expect.conftest import log, record


@pytest.mark.parametrize(
    ("event", "found"),
    [
        (log(2.5, "heard"), 2.0),
        (OutputLine(2.5, "talker", "heard"), 2.0),
        (log(1.5, "before"), inf),
        (OutputLine(2.5, "other", "not the talker"), inf),
    ],
)
def test_the_first_that_was_sent_counts(event: Event, found: float) -> None:
    assert first_reaction(record(event), "talker", (3.0, 2.0)) == found


def test_nothing_was_sent() -> None:
    assert first_reaction(record(log(1.0, "hello")), "talker", ()) == inf


@pytest.mark.parametrize(("frame", "found"), [("rclpy/executors.py", 2.0), ("talk/talker.py", inf)])
def test_an_exception_outside_of_all_callbacks_is_no_reaction(frame: str, found: float) -> None:
    lines = ("Traceback (most recent call last):", f'  File "/ros/{frame}", line 3', "ValueError: no")
    events = [OutputLine(2.5, "talker", text) for text in lines]
    assert first_reaction(record(*events), "talker", (2.0,)) == found

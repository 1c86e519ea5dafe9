"""How often messages come, in the eyes of a check."""

from __future__ import annotations

import contextlib
from itertools import accumulate
from types import SimpleNamespace

import pytest

from course.evidence.events import MessageSeen
from course.evidence.messages import Decoder
from course.evidence.recording import Recording
from course.evidence.topic_view import LogLine, Message, TopicView, expect_period, seconds
from course.feedback import Failure, Feedback, Pace

from .conftest import HELLO, STRING


def times(*intervals: float) -> tuple[float, ...]:
    return tuple(accumulate(intervals, initial=1.0))


def failure(given: tuple[float, ...], period: float = 0.5, tolerance: float = 0.2) -> Feedback | None:
    try:
        expect_period(given, period, what="messages on /talk", tolerance=tolerance, advice="try this")
    except Failure as raised:
        return raised.feedback
    return None


@pytest.mark.parametrize(
    "intervals",
    [
        (0.5, 0.5, 0.5, 0.5),
        (0.41, 0.41, 0.41, 0.41),
        (0.59, 0.59, 0.59, 0.59),
        (0.5, 0.5, 30.0, 0.5),  # one straggler
        (0.5, 0.0, 0.5, 0.5, 0.5),
        (0.1, 0.5, 0.5, 0.9, 0.5),
        (0.3, 0.3, 0.7, 0.7),  # the median is between the two in the middle
    ],
)
def test_the_median_is_what_counts(intervals: tuple[float, ...]) -> None:
    assert failure(times(*intervals)) is None


@pytest.mark.parametrize(
    ("intervals", "seen"),
    [
        ((0.39,) * 4, "one every 0.39 s (2.56 Hz)"),
        ((0.61,) * 4, "one every 0.61 s (1.64 Hz)"),
        ((1.0,) * 4, "one every 1.00 s (1 Hz)"),
        ((0.0005,) * 4, "one every 0.5 ms (2e+03 Hz)"),
        ((0.0,) * 4, "one every 0 ms (all at once)"),
        ((5.0,), "one every 5.00 s (0.2 Hz)"),  # one interval is enough to see that it is wrong
    ],
)
def test_another_period_is_told_with_both_figures(intervals: tuple[float, ...], seen: str) -> None:
    found = failure(times(*intervals))
    assert found is not None
    assert found.summary.startswith("The messages on /talk come every")
    assert found.summary.endswith("not every 0.50 s.")
    assert (found.expected, found.seen) == ("one every 0.50 s (2 Hz)", seen)
    assert found.advice == "try this"


@pytest.mark.parametrize(
    ("interval", "tolerance", "fits"),
    [(0.75, 0.5, True), (0.25, 0.5, True), (0.7501, 0.5, False), (0.2499, 0.5, False), (0.5, 0.0, True)],
)
def test_the_edges_of_the_tolerance_belong_to_it(interval: float, tolerance: float, fits: bool) -> None:
    given = tuple(interval * n for n in range(5))
    assert (failure(given, 0.5, tolerance) is None) is fits


@pytest.mark.parametrize("count", [0, 1, 2, 3, 4])
def test_too_few_tell_nothing(count: int) -> None:
    found = failure(tuple(0.5 * n for n in range(count)))
    assert found is not None
    assert found.summary == f"Only {count} messages on /talk came, too few to tell how often they come."
    assert (found.expected, found.seen) == ("at least 5, one every 0.50 s", str(count))


def test_five_are_enough() -> None:
    assert failure(tuple(0.5 * n for n in range(5))) is None


def test_of_a_topic() -> None:
    messages = tuple(Message(0.5 * n, STRING, None) for n in range(5))
    view = TopicView("/talk", messages, 0, 3.0)
    view.expect_period(0.5)
    with pytest.raises(Failure, match=r"messages on /talk come every 0\.50 s, not every 1\.00 s"):
        view.expect_period(1.0, advice="slower")


def test_a_message_that_cannot_be_read_has_no_data() -> None:
    decoder = Decoder({STRING: "string data"})
    assert Message.of(1.0, "/talk", STRING, HELLO, decoder).data.data == "hello"
    assert not Message.of(1.0, "/talk", STRING, b"\0\1\0\0", decoder).data


@pytest.mark.parametrize(("level", "name"), [(10, "DEBUG"), (20, "INFO"), (40, "ERROR"), (21, "21")])
def test_a_line_of_the_log(level: int, name: str) -> None:
    data = SimpleNamespace(name="talker", level=level, msg="hello")
    assert LogLine.of(Message(1.0, "", data)) == LogLine(1.0, "talker", name, "hello")


def test_a_line_of_the_log_that_cannot_be_read() -> None:
    assert LogLine.of(Message(1.0, "", None)) == LogLine(1.0, "", "INFO", "")


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.5, "0.50 s"), (12.345, "12.35 s"), (0.01, "0.01 s"), (0.0023, "2.3 ms"), (0.0, "0 ms")],
)
def test_durations_for_people(value: float, text: str) -> None:
    assert seconds(value) == text


@pytest.mark.parametrize("period", [0.5, 5.0])
def test_a_recording_knows_what_was_asked_of_it(period: float) -> None:
    """Whether it was so or not."""
    recording = Recording(
        "x", tuple(MessageSeen(n / 2, "/talk", STRING, HELLO) for n in range(9)), {STRING: ""}
    )
    with contextlib.suppress(Failure):
        recording.topic("/talk").expect_period(period, tolerance=0.2)
    assert recording.paces == [Pace("/talk", pytest.approx(period * 0.8), pytest.approx(period * 1.2))]

"""How often messages come, in the eyes of a check."""

from __future__ import annotations

import contextlib
from itertools import accumulate
from types import SimpleNamespace

import pytest

from course.evidence.messages import Decoder
from course.evidence.recording import Recording
from course.evidence.topic_view import LogLine, Message, TopicView, paces_asked, seconds
from course.grading.expect.periods import expect_period
from course.model.events import MessageSeen
from course.model.feedback import Failure, Feedback, Location, Pace
from tests.golden import golden

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
    "intervals", [(0.39,) * 4, (0.61,) * 4, (1.0,) * 4, (0.0005,) * 4, (0.0,) * 4, (5.0,)]
)
def test_another_period_is_told_with_both_figures(intervals: tuple[float, ...]) -> None:
    golden(failure(times(*intervals)))


@pytest.mark.parametrize(
    ("interval", "tolerance", "fits"),
    [(0.75, 0.5, True), (0.25, 0.5, True), (0.7501, 0.5, False), (0.2499, 0.5, False), (0.5, 0.0, True)],
)
def test_the_edges_of_the_tolerance_belong_to_it(interval: float, tolerance: float, fits: bool) -> None:
    given = tuple(interval * n for n in range(5))
    assert (failure(given, 0.5, tolerance) is None) is fits


@pytest.mark.parametrize("count", [0, 1, 2, 3, 4])
def test_too_few_tell_nothing(count: int) -> None:
    golden(failure(tuple(0.5 * n for n in range(count))))


def test_five_are_enough() -> None:
    assert failure(tuple(0.5 * n for n in range(5))) is None


def test_of_a_topic() -> None:
    messages = tuple(Message(0.5 * n, STRING, None) for n in range(5))
    view = TopicView("/talk", messages, 0, 3.0)
    expect_period(view, 0.5)
    assert view.between(0.5, 1.5).times == (0.5, 1.0)
    place = Location("talk.py", 3)
    with pytest.raises(Failure, match=r"messages on /talk come every 0\.50 s, not every 1\.00 s") as caught:
        expect_period(view, 1.0, advice="slower", where=(place,))
    assert caught.value.feedback.where == (place,)


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
def test_a_pace_that_is_asked_for_is_known(period: float) -> None:
    """Whether it was so or not."""
    recording = Recording(
        "x", tuple(MessageSeen(n / 2, "/talk", STRING, HELLO) for n in range(9)), {STRING: ""}
    )
    with paces_asked() as paces, contextlib.suppress(Failure):
        expect_period(recording.topic("/talk"), period, tolerance=0.2)
    assert paces == [Pace("/talk", pytest.approx(period * 0.8), pytest.approx(period * 1.2))]

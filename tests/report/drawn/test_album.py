"""All pictures of a recording together, the words before them, and what is kept back."""

from __future__ import annotations

import pytest

from course.model import events as kinds
from course.model import replace
from course.report.pictures.recording_text import (
    belongs,
    bytes_of,
    is_secret,
    render_pictures,
    render_recording,
    render_summary,
)
from tests.report.conftest import Page
from tests.report.drawn.recordings import PACE, judged, steady
from tests.report.pictures.recordings import ADD, COUNTER, call, recording


def test_the_topic_that_a_pace_was_asked_of_is_plotted_with_its_band(page: Page) -> None:
    busy = steady(50, 0.1, "/busy")
    render_pictures(page.console, recording(*steady(9), *busy), judged(PACE))
    assert "Time between messages (s): /counted" in page.lines
    assert "Time between messages (s): /busy" not in page.lines
    assert "expected 0.4 to 0.6 s" in page.text


def test_without_a_result_the_busiest_is_plotted_without_a_band(page: Page) -> None:
    render_pictures(page.console, recording(*steady(9)), None)
    assert "Time between messages (s): /counted" in page.lines
    assert "xpected" not in page.text


def test_answers_are_plotted(page: Page) -> None:
    answers = (kinds.ServiceAnswered(n + 0.25, "/add", ADD, "client", f"add{n}", b"") for n in range(5))
    render_pictures(page.console, recording(*(call(n, "add", n) for n in range(5)), *answers), None)
    assert "Time until the answer (s): /add" in page.lines


@pytest.mark.parametrize("secret", [kinds.Drawn(0.1, 8675309), kinds.Acted(0.1, "found", "/hidden")])
def test_a_mystery_is_not_shown(page: Page, secret: kinds.Event) -> None:
    what = recording(*COUNTER, secret)
    assert is_secret(what)
    render_recording(page.console, what, 1000, None)
    assert page.text.startswith("The recording of a mystery is not shown")
    assert all(word not in page.text for word in ("8675309", "/hidden", "/counted", "counter"))


def test_what_the_grader_keeps_for_itself_is_not_shown(page: Page) -> None:
    mine = "/home/x/graders/probes/p.py"
    secret = (
        kinds.FileKept(0.2, "answer", "42424242"),
        kinds.Marked(0.3, "m", "42424242"),
        kinds.Probed(0.3, "probe", ('{"question": "42424242"}',), True),
        kinds.ProcessStarted(0.1, "probe", ("python3", mine)),
    )
    render_recording(page.console, recording(*COUNTER, *secret), 1000, None)
    assert "42424242" not in page.text and mine not in page.text


def test_a_result_belongs_to_the_recording_that_it_judged() -> None:
    what = recording(*COUNTER, duration=6.0004)
    assert belongs(judged(what=what), what)
    assert not belongs(judged(what=replace(what, duration=5.9)), what)
    assert not belongs(None, what)
    assert not belongs(judged(), recording(duration=0.0))


def test_the_summary_names_topics_types_counts_rates_and_ends(page: Page) -> None:
    render_summary(page.console, recording(*COUNTER, kinds.ProcessStarted(1.0, "other", ())), 16_020)
    assert page.lines == [
        "18-counter: 6.0 s recorded, 16 kB",
        "Messages",
        "  /counted: 6 messages, one every 0.50 s (2 Hz), std_msgs/msg/Int32",
        "  /told: 1 message sent by the grader, std_msgs/msg/Int32",
        "Programs",
        "  counter: ended with exit code 0 after 5.0 s",
        "  other: still ran at the end",
    ]


def test_an_empty_recording(page: Page) -> None:
    render_recording(page.console, recording(duration=0.0), 0, None)
    assert "Nothing was recorded." in page.text


@pytest.mark.parametrize(("size", "said"), [(0, "0 bytes"), (1500, "2 kB"), (3_140_000, "3.1 MB")])
def test_sizes(size: int, said: str) -> None:
    assert bytes_of(size) == said

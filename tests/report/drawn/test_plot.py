"""Signals in the terminal."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from course.model import events as kinds
from course.report.pictures.plot_text import ROWS, render_plot
from course.report.pictures.signals import Curve, Signal, intervals_of, latencies_of, signals_of
from tests.report.conftest import Page
from tests.report.drawn.recordings import steady
from tests.report.pictures.recordings import ADD, COUNTER, call, joints, number, recording


def rows(page: Page) -> list[str]:
    return [line.split("│")[1] for line in page.lines if "│" in line]


def signal(*values: float, unit: str = "s") -> Signal:
    points = tuple((1.0 + place, value) for place, value in enumerate(values))
    return Signal("Time between messages", "/counted", unit, (Curve("since the one before", points),))


def test_what_lies_outside_the_band_has_another_mark(page: Page) -> None:
    render_plot(page.console, signal(0.5, 0.5, 1.0, 0.5, 0.1), 6.0, (0.4, 0.6))
    drawn = "".join(rows(page))
    assert (drawn.count("●"), drawn.count("✕")) == (3, 2)
    inside = [row for row in rows(page) if "░" in row]
    assert 1 <= len(inside) < ROWS and any("●" in row for row in inside)
    assert "░░ expected 0.4 to 0.6 s (the median), ✕ outside" in page.text
    assert "5 values drawn, 0.1 to 1 s, median 0.5 s" in page.text


def test_a_short_signal_has_an_axis_of_its_own(page: Page) -> None:
    render_plot(page.console, signal(0.5, 0.6, 0.7), 60.0)
    assert "2 s" in page.text and "60 s" not in page.text
    marks = [column for row in rows(page) for column, mark in enumerate(row) if mark == "●"]
    assert max(marks) - min(marks) > 40


def test_without_a_band_nothing_is_said_of_one(page: Page) -> None:
    render_plot(page.console, signal(0.5, 0.6), 6.0)
    assert "░" not in page.text and "expected" not in page.text and "✕" not in page.text


def test_joints_are_told_apart_by_letters(page: Page) -> None:
    stream = [joints(place * 0.1, elbow=place * 0.5, wrist=-place) for place in range(1, 9)]
    values, _ = signals_of(recording(*stream))
    render_plot(page.console, values, 6.0)
    assert "a" in rows(page)[0] and "b" in rows(page)[-1]
    assert "  a elbow: 8 values drawn, 0.5 to 4, median 2.25" in page.lines
    assert "  b wrist: 8 values drawn, -8 to -1, median -4.5" in page.lines


@pytest.mark.parametrize("width", [80, 40])
def test_thousands_of_messages_and_an_odd_name_fit(narrow_page: Callable[[int], Page], width: int) -> None:
    name = "/\x1b]0;title\x07" + "long" * 40
    page = narrow_page(width)
    stream = [number(0.001 * place, place % 7, name) for place in range(6000)]
    found = intervals_of(recording(*stream), name)
    assert found is not None
    for each in (*signals_of(recording(*stream)), found):
        render_plot(page.console, each, 6.0, (0.0009, 0.0011))
    assert "\x1b" not in page.text and "title" not in page.text
    assert max(map(len, page.lines)) <= width


@pytest.mark.parametrize("values", [(0.0,), (7.0, 7.0), (-1e14, 1e14), (1e-9,)])
def test_odd_ranges(page: Page, values: tuple[float, ...]) -> None:
    for unit in ("", "s"):
        render_plot(page.console, signal(*values, unit=unit), 6.0, (0.4, 0.6))
        render_plot(page.console, signal(*values, unit=unit), 6.0)
    assert "✕" in page.text and "●" in page.text


def test_intervals_of_one_topic_and_how_long_answers_took() -> None:
    what = recording(*COUNTER, *steady(20, 0.1, "/other"))
    counted = intervals_of(what, "/counted")
    assert counted is not None and counted.topic == "/counted"
    assert intervals_of(what, "/nowhere") is None
    assert latencies_of(what) is None, "one call is too few"


def test_answers_are_timed_from_their_calls() -> None:
    answers = (kinds.ServiceAnswered(n + 0.25, "/add", ADD, "client", f"add{n}", b"") for n in range(5))
    found = latencies_of(recording(*(call(n, "add", n) for n in range(6)), *answers))
    assert found is not None and found.topic == "/add"
    assert [value for _, value in found.curves[0].points] == [0.25] * 5


def test_answers_of_the_grader_itself_are_not_timed() -> None:
    ours = [
        kind(n + more, "/add", ADD, "server", f"{n}", *rest)
        for n in range(9)
        for kind, more, rest in ((kinds.ServiceCalled, 0, ("", b"")), (kinds.ServiceAnswered, 0.1, (b"",)))
    ]
    assert latencies_of(recording(*ours)) is None

"""The time line in the terminal."""

from __future__ import annotations

import io
import re
from collections.abc import Callable

import pytest
from rich.cells import cell_len
from rich.console import Console

from course.evidence.recording import Recording
from course.model import events as kinds
from course.model.result import Result
from course.report.console import open_console
from course.report.pictures.lanes import Told
from course.report.pictures.timeline_text import rate, render_line
from tests.report.conftest import Page
from tests.report.drawn.recordings import PACE, TYPO, failed, judged, steady
from tests.report.gradebook.hostile import TEXTS
from tests.report.pictures.recordings import COUNTER, flood, recording


def drawn(page: Page, what: Recording, result: Result | None = None) -> list[str]:
    render_line(page.console, what, Told.by(result))
    return page.lines


def after(lines: list[str], beginning: str) -> str:
    """The track of the lane whose words begin so, where they take one line."""
    place = next(place for place, line in enumerate(lines) if line.startswith(beginning))
    return next(line for line in lines[place:] if not re.search("[a-z]", line))[2:]


def test_programs_nodes_messages_calls_signals_and_ends_lie_on_one_scale(page: Page) -> None:
    lines = drawn(page, recording(*COUNTER))
    program = after(lines, "Program counter:")
    assert len(lines[-3]) == 78 and lines[-2].startswith("  0 s ")
    begin, flag, end = (program.index(mark) for mark in "├▼┤")
    assert [round(place * 6 / 75, 1) for place in (begin, flag, end)] == [0.5, 5.0, 5.5]
    assert after(lines, "Messages on /counted:").count("●") == 6
    assert after(lines, "Sent by the grader to /told:").strip() == "●"
    assert after(lines, "Calls of /add:").strip() == "●────"
    assert "Ctrl+C at 5.00 s; ended at 5.50 s" in " ".join(page.text.split())


def test_a_topic_on_which_nothing_came_has_a_lane_too(page: Page) -> None:
    lines = drawn(page, TYPO, judged(failed("/counted", "/counteds", "it publishes")))
    place = lines.index("Messages on /counted: none came.")
    assert lines[place + 1 : place + 3] == ["  no  it publishes: expected /counted, seen /counteds", ""]
    assert "Not as expected" not in page.text


def test_the_legend_explains_what_is_drawn_and_nothing_else(page: Page) -> None:
    legend = drawn(page, recording(*COUNTER))[-1]
    assert legend == "  ├ begins, ┤ ends, ┴ printed, ▼ signal, command, or limit, ● one"


def test_many_in_one_place_are_counted(page: Page) -> None:
    events = [*steady(4, 0.0), *(kinds.MessageSeen(6.0, "/b", "t", b"") for _ in range(40))]
    lines = drawn(page, recording(*events))
    assert after(lines, "Messages on /counted:") == "4"
    assert after(lines, "Messages on /b:").strip() == "█"
    assert lines[-1].endswith("█ ten or more, 2 to 9 that many")


def test_the_rate_stands_beside_the_one_that_was_expected(page: Page) -> None:
    text = " ".join(" ".join(drawn(page, recording(*steady(9)), judged(PACE))).split())
    assert "One every 0.50 s (2 Hz). Expected one every 0.40 s to 0.60 s." in text


def test_what_a_check_expected_stands_at_what_it_is_about(page: Page) -> None:
    result = judged(failed("/counter", "/counted", "it is called"), failed("five lines", "none", "it speaks"))
    lines = drawn(page, recording(*COUNTER), result)
    place = next(place for place, line in enumerate(lines) if line.startswith("Messages on /counted"))
    assert lines[place + 2] == "  no  it is called: expected /counter, seen /counted"
    assert lines[-3:] == ["", "Not as expected", "  no  it speaks: expected five lines, seen none"]


@pytest.mark.slow
@pytest.mark.parametrize("width", [80, 40])
@pytest.mark.parametrize("name", [*TEXTS, "a" * 300], ids=lambda text: repr(text[:12]))
def test_it_fits_and_hostile_names_stay_text(
    narrow_page: Callable[[int], Page], width: int, name: str
) -> None:
    page = narrow_page(width)
    bad = failed(name, name, name)
    drawn(page, flood(name[:300]), judged(bad))
    assert "\x1b" not in page.text and "\r" not in page.text
    assert max(map(cell_len, page.lines)) <= width
    assert "Not drawn: " in page.text


def test_nothing_and_one_instant(page: Page, narrow_page: Callable[[int], Page]) -> None:
    assert drawn(page, recording()) == ["What happened", "  Nothing was recorded."]
    instant = drawn(narrow_page(40), recording(kinds.ProcessStarted(0.0, "a", ()), duration=0.0))
    assert instant[1].startswith("Program a:")


def test_a_terminal_that_has_only_ascii() -> None:
    stream = io.TextIOWrapper(io.BytesIO(), encoding="ascii")
    console = open_console(stream, width=80)
    assert isinstance(console, Console)
    render_line(console, recording(*COUNTER, *steady(40, 0.001, "/b")), Told())
    stream.flush()
    assert b"#" in stream.buffer.getvalue()  # type: ignore[attr-defined]


def test_colour_only_adds(page: Page) -> None:
    result = judged(failed("/counter", "/counted"))
    bright = Page(Console(file=io.StringIO(), force_terminal=True, width=80), io.StringIO())
    with bright.console.capture() as colored:
        render_line(bright.console, recording(*COUNTER), Told.by(result))
    assert "\x1b[" in colored.get()
    plain = re.sub(r"\x1b\[[0-9;]*m", "", colored.get()).splitlines()
    assert [line.rstrip() for line in plain] == drawn(page, recording(*COUNTER), result)


@pytest.mark.parametrize(
    ("times", "said"),
    [
        ((), ""),
        ((1, 2, 3, 4), ""),
        ((1,) * 9, "all at once"),
        ((0, 0.0002, 0.0004, 0.0006, 0.0008), "one every 0.2 ms (5000 Hz)"),
        ((1, 2, 3, 4, 9), "one every 1.00 s (1 Hz)"),
    ],
)
def test_the_rate_in_words(times: tuple[float, ...], said: str) -> None:
    assert rate(times) == said

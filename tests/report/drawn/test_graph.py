"""Who publishes and who listens, and the two names that differ by a typo."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from rich.cells import cell_len

from course.evidence.recording import Recording
from course.model import events as kinds
from course.report.pictures.graph_text import Connection, render_graph, slips, topics_of
from course.report.pictures.lanes import Told
from tests.report.conftest import Page
from tests.report.drawn.recordings import CALLS, TYPO, end, failed, graph, judged
from tests.report.gradebook.hostile import TEXTS
from tests.report.pictures.recordings import NUMBER, recording


def drawn(page: Page, what: Recording, told: Told | None = None) -> list[str]:
    render_graph(page.console, what, told or Told())
    return page.lines


def test_a_line_for_each_topic_and_service(page: Page) -> None:
    assert drawn(page, CALLS) == [
        "Who publishes, and who listens",
        "  the grader ─→ /told ─→ /adder",
        "Who calls a service, and who answers",
        "  /asker, the grader ─→ /add ─→ /adder",
    ]


def test_the_slip_is_marked_without_colour_too(page: Page, colour_page: Page) -> None:
    lines = drawn(page, TYPO)
    assert lines[1:3] == ["! nobody ─→ /counted ─→ the grader", "! /counter ─→ /counteds ─→ nobody"]
    assert lines[3].startswith("! /counted and /counteds are nearly alike")
    assert "\x1b[1;31m/counteds" in "".join(drawn(colour_page, TYPO))


def test_a_name_that_a_check_expected_is_drawn_too(page: Page) -> None:
    there = recording(graph(end("/counteds", "publisher", "/counter")))
    told = Told.by(judged(failed("/counted", "/counteds"), failed("/elsewhere", None)))
    lines = drawn(page, there, told)
    assert "! nobody ─→ /counted ─→ nobody" in lines
    assert "/elsewhere" not in page.text


@pytest.mark.parametrize(
    ("one", "other", "is_slip"),
    [
        (("/quote", ("/a",), ()), ("/quotes", (), ("/b",)), True),
        (("/quote", ("/a",), ()), ("/quotes", ("/b",), ()), False),  # both publish only
        (("/quote", ("/a",), ("/b",)), ("/quotes", (), ("/b",)), False),  # one is whole
        (("/quote", ("/a",), ()), ("/color", (), ("/b",)), False),  # not alike
        (("/quote", ("/a",), ()), ("/quotes", (), ()), True),
        (("/quote", ("/a",), ("/b",)), ("/quotes", (), ()), False),
        (("/quote", (), ()), ("/quotes", (), ()), False),
    ],
)
def test_what_is_a_slip(
    one: tuple[str, tuple[str, ...], tuple[str, ...]],
    other: tuple[str, tuple[str, ...], tuple[str, ...]],
    is_slip: bool,
) -> None:
    pairs = list(slips([Connection(*one), Connection(*other)]))
    assert pairs == ([(one[0], other[0])] if is_slip else [])


def test_the_grader_s_own_ends_are_told_of_recordings_of_before_too() -> None:
    heard = kinds.MessageSeen(1.0, "/counted", NUMBER, b"")
    (topic,) = topics_of(recording(graph(end("/counted", "publisher", "")), heard))
    assert topic == Connection("/counted", ("somebody",), ("the grader",))


def test_nothing_was_seen(page: Page) -> None:
    assert drawn(page, recording()) == ["No topics or services were seen."]


@pytest.mark.parametrize("width", [80, 40])
@pytest.mark.parametrize("name", TEXTS, ids=lambda text: repr(text[:12]))
def test_hostile_names_and_hundreds_of_topics(
    narrow_page: Callable[[int], Page], width: int, name: str
) -> None:
    page = narrow_page(width)
    name = name[:250]
    ends = [end(f"/{name}{n}", "publisher", f"/{name}{m}") for n in range(60) for m in range(9)]
    drawn(page, recording(graph(*ends)))
    assert "\x1b" not in page.text and "\r" not in page.text
    assert max(map(cell_len, page.lines)) <= width
    assert "  ... 40 more ..." in page.lines and "and 3 more" in " ".join(page.text.split())

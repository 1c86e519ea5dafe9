"""How similar pairs are shown, with texts that strangers chose."""

from __future__ import annotations

import io
from html.parser import HTMLParser

import pytest
from rich.cells import cell_len

from course.report.console import open_console
from course_similar.comparison import Comparison, Match, Pair, Passage, Side
from course_similar.page import page
from course_similar.report import LINES, render_similar

CODE = ("class Quote(Node):", "    def say(self):", "        self.publish('hi')")
ONE = Passage("src/quotes/quote.py", 7, CODE)
OTHER = Passage("src/mine/own.py", 107, tuple(line.replace("self", "me") for line in CODE))
PAIR = Pair(Side("Ann Ant", 0.834, 3), Side("Bob Bee", 0.5, 1), (Match(ONE, OTHER), Match(OTHER, ONE)), 2)
FOUND = Comparison((PAIR,), compared=12, threshold=0.6)
EVIL = "\x1b]0;title\x07\x1b[2J<script>alert(1)</script>\u202e&amp;\"'--><b>\r\0"
HOSTILE = Comparison(
    pairs=(
        Pair(
            Side(EVIL, 1.0, 3),
            Side(EVIL * 100, 1.0, 3),
            (Match(Passage(EVIL, 1, (EVIL, "漢字" * 200, "\ud800")), Passage(EVIL * 100, 1, ("", "\t\tx"))),),
        ),
    ),
    compared=2,
    threshold=0.6,
    without=(EVIL,),
    remarks=(EVIL,),
)


def shown(comparison: Comparison, width: int = 80) -> str:
    stream = io.StringIO()
    render_similar(open_console(stream, width=width), comparison)
    return stream.getvalue()


def test_both_sides_stand_beside_each_other() -> None:
    lines = shown(FOUND).split("\n")
    assert "1.  Ann Ant  83%, 3 lines" in lines
    assert "    Bob Bee  50%, 1 line" in lines
    (row,) = (line for line in lines if "def say(self)" in line)
    assert [side.strip() for side in row.split("|")] == ["8     def say(self):", "108     def say(me):"]
    (places,) = (line for line in lines if "quote.py" in line)
    assert [side.strip() for side in places.split("|")] == [
        "src/quotes/quote.py:7-9",
        "src/mine/own.py:107-109",
    ]
    assert "    and 3 shorter passages" in lines


@pytest.mark.parametrize("width", [40, 80, 100])
def test_no_row_is_wider_than_the_terminal(width: int) -> None:
    long = Passage("folder/" * 40 + "end.py", 1, ("漢字x" * 90,) * 3)
    pair = Pair(PAIR.one, PAIR.other, (Match(long, long),))
    rows = [line for line in shown(Comparison((pair,), 2, 0.6), width).split("\n") if " | " in line]
    assert len(rows) == 4
    assert max(map(cell_len, rows)) <= width
    assert "end.py:1-3" in rows[0]


def test_a_long_passage_is_cut() -> None:
    long = Passage("a.py", 1, tuple(f"line_{number}" for number in range(40)))
    text = shown(Comparison((Pair(PAIR.one, PAIR.other, (Match(long, ONE),)),), 2, 0.6))
    assert f"line_{LINES - 1} " in text and f"line_{LINES} " not in text
    assert f"    {40 - LINES} more lines" in text.split("\n")


def test_it_says_that_it_is_no_verdict_and_what_was_left_out() -> None:
    found = Comparison((PAIR,), 12, 0.6, 3, without=("Cy",), remarks=("Dee: a file was left out.",))
    for text in (" ".join(shown(found).split()), " ".join("".join(page(found)).split())):
        assert "12 submissions compared. 4 pairs are alike: 60% or more of" in text
        assert "Alike is not a verdict" in text
        assert "3 more pairs not shown here" in text
        assert "Note: Too little code of their own to compare, apart from what the course gives: Cy." in text
        assert "Note: Dee: a file was left out." in text


def test_nothing_found() -> None:
    text = shown(Comparison((), 5, 0.6))
    assert text.startswith("5 submissions compared. No pair is alike") and "verdict" not in text


def test_hostile_texts_do_nothing_on_a_terminal() -> None:
    text = shown(HOSTILE)
    assert not set("\x1b\x07\x00\r\u202e\ud800") & set(text)
    assert "<script>alert(1)</script>" in text  # it is only text here


class Tags(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.seen: set[str] = set()
        self.attributes: set[str] = set()

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.seen.add(tag)
        self.attributes |= {name for name, _ in attributes}


def test_hostile_texts_do_nothing_on_the_page() -> None:
    text = "".join(page(HOSTILE))
    assert not set("\x1b\x07\x00\r\u202e\ud800") & set(text)
    text.encode()
    tags = Tags()
    tags.feed(text)
    assert not tags.seen & {"script", "img", "iframe", "link"}
    assert tags.attributes == {"lang", "charset", "name", "content", "http-equiv", "class", "id", "href"}
    assert "default-src 'none'" in text


def test_the_page_shows_all_passages_with_line_numbers() -> None:
    text = "".join(page(FOUND))
    assert text.count('<div class="both">') == 2
    assert "<h3>src/mine/own.py:107-109</h3>" in text
    assert "<b> 108 </b>    def say(me):" in text
    assert "2 shorter passages not shown." in text
    assert 'href="#pair-1"' in text and 'id="pair-1"' in text

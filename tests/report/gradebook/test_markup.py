"""Texts inside Markdown stay texts, and stay the same texts."""

from __future__ import annotations

import pytest

from course.report.gradebook import letter
from course.report.gradebook.cleaning import Cleaner
from tests.report.gradebook import hostile, reading

CLEAN = [Cleaner().line(text, 5000) for text in hostile.TEXTS]


@pytest.mark.parametrize("text", CLEAN, ids=lambda text: ascii(text[:20]))
def test_a_text_is_only_text_and_nothing_is_lost(text: str) -> None:
    for shown in (letter.plain(text), letter.prose(text)):
        assert reading.harm(shown) == []
        assert {token.type for token in reading.tokens(shown)} <= {
            *("paragraph_open", "inline", "text", "text_special", "code_inline", "paragraph_close"),
        }
    assert reading.shown(letter.plain(text)).strip() == " ".join(text.split(" ")).strip()


@pytest.mark.parametrize("text", CLEAN, ids=lambda text: ascii(text[:20]))
def test_code_is_code_to_its_end(text: str) -> None:
    if text.strip():
        (code,) = [token for token in reading.tokens(letter.code(text)) if token.type == "code_inline"]
        assert code.content.strip() == text.strip()


@pytest.mark.parametrize("indent", ["", "  "])
def test_no_line_ends_a_block(indent: str) -> None:
    block = letter.fenced(CLEAN, indent)
    page = f"- item\n\n{block}\n" if indent else block
    (fence,) = [token for token in reading.tokens(page) if token.type == "fence"]
    assert fence.content.removesuffix("\n").split("\n") == [line.rstrip() for line in CLEAN]


def test_words_of_ours_stay_readable_as_they_are() -> None:
    for text in (
        "The node publishes on `/amazing_quotes`, not `/amazing_quote`.",
        "18-publisher: A publisher",
        "python_package_that_uses_the_messages.amazing_quote_publisher_node:main, 0.50 s (2 Hz)!",
        'needs "messages arrive"',
    ):
        assert letter.prose(text) == text


def test_no_dollar_begins_a_formula() -> None:
    assert letter.plain("$x$ and $HOME") == r"\$x\$ and \$HOME"


def test_code_in_a_sentence_is_code() -> None:
    shown = [t.content for t in reading.tokens(letter.prose("Use `<b>` or `a|b`")) if t.type == "code_inline"]
    assert shown == ["<b>", "a|b"]
    both = [t.content for t in reading.tokens(letter.prose("`a``b`")) if t.type == "code_inline"]
    assert both == ["a", "b"]


def test_a_newline_begins_nothing() -> None:
    assert letter.plain("a\n# b") == letter.prose("a\n# b") == "a # b"


def test_a_cell_ends_where_its_row_says() -> None:
    cell = letter.plain("x | y `|` \\| z")
    table = f"| a | b |\n| --- | --- |\n| {cell} | b |\n"
    cells = [token for token in reading.tokens(table) if token.type == "td_open"]
    assert len(cells) == 2

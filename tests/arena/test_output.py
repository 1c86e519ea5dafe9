"""Bytes of a terminal become lines: complete, clean, and limited."""

from __future__ import annotations

import pytest

from course.arena.process import CUT, MAX_LINE, MAX_TAIL, MAX_TOTAL, LineSplitter

LINE = b"x" * 999 + b"\n"


def lines_of(*chunks: bytes) -> list[str]:
    splitter = LineSplitter()
    return [line for chunk in chunks for line in splitter.feed(chunk)] + splitter.rest()


@pytest.mark.parametrize(
    ("data", "lines"),
    [
        (b"", []),
        (b"one\n", ["one"]),
        (b"one\ntwo", ["one", "two"]),
        (b"\n\n", ["", ""]),
        (b"one\r\n", ["one"]),
        (b"a\tb\n", ["a\tb"]),
        (b"\x1b[31mred\x1b[0m\n", ["red"]),
        (b"\x1b[1;38;5;200mpink\x1b[m\x1b[K\n", ["pink"]),
        (b"\x1b]0;a title\x07text\n", ["text"]),
        (b"\x1b]8;;http://example.com\x1b\\link\x1b]8;;\x1b\\\n", ["link"]),
        (b"\x1bPdevice control\x1b\\text\n", ["text"]),
        (b"\x1b(Btext\x1b=\x1b>\n", ["text"]),
        (b"\x00\x07\x08bell\x7f\n", ["bell"]),
        ("\x9b31mred\x85\n".encode(), ["31mred"]),
        ("häufig – 日本語 ✓\n".encode(), ["häufig – 日本語 ✓"]),
        (b"\xff\n", ["\ufffd"]),
    ],
)
def test_lines(data: bytes, lines: list[str]) -> None:
    assert lines_of(data) == lines
    assert lines_of(*(data[i : i + 1] for i in range(len(data)))) == lines


def test_no_escape_is_left_in_random_bytes() -> None:
    data = bytes(index * 7919 % 256 for index in range(5000)).replace(b"\n", b"") + b"\n"
    assert not [char for char in "".join(lines_of(data)) if char < " " and char != "\t"]


def test_a_long_line_in_pieces_is_cut_once() -> None:
    splitter = LineSplitter()
    for _ in range(100):
        assert splitter.feed(b"x" * 1000) == []
    assert splitter.feed(b"\nnext\n") == ["x" * MAX_LINE + CUT, "next"]
    assert splitter.dropped == 100_000 - MAX_LINE


def flooded() -> LineSplitter:
    splitter = LineSplitter()
    splitter.feed(LINE * (MAX_TOTAL // len(LINE) + 1))
    return splitter


def test_after_a_flood_the_last_lines_are_kept() -> None:
    splitter = flooded()
    traceback = b"Traceback\n  File\nValueError: 1\n"
    assert splitter.feed(b"noise\n" * 10_000 + traceback) == []
    kept = splitter.rest()
    assert kept[-3:] == ["Traceback", "  File", "ValueError: 1"]
    assert set(kept[:-3]) == {"noise"}
    assert sum(len(line) + 1 for line in kept) <= MAX_TAIL
    assert splitter.dropped == 60_000 + len(traceback) - sum(len(line) + 1 for line in kept)


def test_a_little_more_than_the_limit_loses_nothing() -> None:
    splitter = flooded()
    splitter.feed(b"one\ntw")
    splitter.feed(b"o\nthree")
    assert splitter.rest() == ["one", "two", "three"]
    assert splitter.dropped == 0


def test_the_line_that_the_limit_cuts_in_two_is_whole() -> None:
    splitter = LineSplitter()
    splitter.feed(LINE * (MAX_TOTAL // len(LINE) + 1) + b"be")
    assert splitter.feed(b"gun\nnext\n") == []
    assert splitter.rest() == ["begun", "next"]


def test_a_line_that_the_flood_begins_in_is_dropped_with_it() -> None:
    splitter = LineSplitter()
    splitter.feed(LINE * (MAX_TOTAL // len(LINE) + 1) + b"be")
    splitter.feed(b"noise\n" * 10_000)
    kept = splitter.rest()
    assert set(kept) == {"noise"}
    assert splitter.dropped == 2 + 60_000 - 6 * len(kept)


def test_a_flood_is_never_held_in_memory() -> None:
    splitter = flooded()
    for _ in range(100):
        splitter.feed(b"y" * 100_000)
    assert sum(map(len, splitter.rest())) <= MAX_TAIL

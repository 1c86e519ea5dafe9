"""Streams in plain text."""

from __future__ import annotations

from course.evidence.stream import Stream
from lib.following import sketch

from .streams import following, swing, ticks

NOTHING = Stream("/arm", (), ())


def test_what_follows_covers_what_was_commanded() -> None:
    commanded = following(ticks(1, 0.01, 2.0), swing())
    seen = following(ticks(1, 0.002, 2.0), swing())
    head, *rows = sketch(commanded, seen, 0)
    assert head == "joint 1 in rad, from 0.0 s to 2.0 s: o commanded, # seen"
    assert len(rows) == 7
    assert rows[0].startswith("   0.20 |") and rows[-1].startswith("  -0.20 |")
    assert "o" not in "".join(rows) and all("#" in row for row in rows)


def test_what_stands_still_leaves_it_bare() -> None:
    commanded = following(ticks(1, 0.01, 2.0), swing())
    rows = sketch(commanded, following(ticks(1, 0.002, 2.0), swing(share=0.0)), 0)[1:]
    assert "o" in rows[0] and "o" in rows[-1]
    assert [("#" in row) for row in rows] == [False] * 3 + [True] + [False] * 3


def test_little_to_draw() -> None:
    assert sketch(NOTHING, NOTHING, 0) == ()
    assert sketch(Stream("/arm", (1.0,), ((2.0,),)), NOTHING, 3) == ()
    rows = sketch(Stream("/arm", (1.0,), ((2.0,),)), NOTHING, 0)
    assert sum(row.count("o") for row in rows[1:]) == 1

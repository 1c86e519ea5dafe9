"""Rows of numbers with their times."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from course.evidence.stream import Stream
from course.evidence.topic_view import Message

STREAM = Stream("/arm", (0.0, 1.0, 2.0, 2.0), ((0.0, 5.0), (1.0, 6.0), (2.0, 7.0), (3.0, 8.0)))


def test_of_messages() -> None:
    messages = (Message(t, "a/msg/B", SimpleNamespace(position=[t, 2])) for t in (0.5, 0.75))
    stream = Stream.of("/arm", "position", messages, lost=3)
    assert stream == Stream("/arm", (0.5, 0.75), ((0.5, 2.0), (0.75, 2.0)), 3)
    assert len(stream) == 2


def test_a_part_of_it() -> None:
    assert STREAM.between(1.0, 2.0).rows == ((1.0, 6.0), (2.0, 7.0), (3.0, 8.0))
    assert STREAM.between(end=0.5).times == (0.0,)
    assert len(STREAM.between(2.5)) == 0


def test_where_it_was_at_a_moment() -> None:
    assert STREAM.at(1.5) == (1.0, 6.0)
    assert STREAM.at(2.0) == (3.0, 8.0)
    assert STREAM.at(-0.1) is None


def test_one_joint() -> None:
    assert STREAM.column(1) == (5.0, 6.0, 7.0, 8.0)
    with pytest.raises(IndexError):
        STREAM.column(2)


def test_widths() -> None:
    assert STREAM.widths == (2,)
    assert Stream("/arm", (0.0, 1.0, 2.0), ((1.0,), (), (2.0,))).widths == (0, 1)
    assert Stream("/arm", (), ()).widths == ()

"""How soon one stream follows the commands on another one. Also draws both as text."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import inf, isclose

from course.api import Stream

Row = tuple[float, ...]

_NEAR = 1e-6
_ROWS, _COLUMNS, _NUMBER = 7, 56, 7
_COMMANDED, _SEEN = "o", "#"


@dataclass(frozen=True)
class Answer:
    """A command, and how the stream answered it.

    sent: its time (s). latency: seconds until a row equal to it; None if there was none before the next
    command. last: the last row before the next command.
    """

    sent: float
    target: Row
    latency: float | None
    last: Row | None


def answers(commands: Stream, stream: Stream) -> tuple[Answer, ...]:
    """The answer to each command, in order."""
    ends = (*commands.times[1:], inf)
    return tuple(
        _answer(sent, target, stream.between(sent, end))
        for sent, target, end in zip(commands.times, commands.rows, ends, strict=True)
    )


def _answer(sent: float, target: Row, stream: Stream) -> Answer:
    came = (t for t, row in zip(stream.times, stream.rows, strict=True) if same(row, target))
    first = next(came, None)
    return Answer(sent, target, None if first is None else first - sent, next(reversed(stream.rows), None))


def same(one: Row, other: Row, near: float = _NEAR) -> bool:
    """Whether both have the same joints at the same positions."""
    return len(one) == len(other) and all(
        isclose(a, b, rel_tol=near, abs_tol=near) for a, b in zip(one, other, strict=True)
    )


def alike(stream: Stream, near: float = _NEAR) -> bool:
    """Whether all joints move the same way, no matter where each of them is."""
    return all(_moved_alike(before, after, near) for before, after in pairwise(stream.rows))


def _moved_alike(before: Row, after: Row, near: float) -> bool:
    if len(before) != len(after):
        return False
    moves = [b - a for a, b in zip(before, after, strict=True)]
    return not moves or max(moves) - min(moves) <= near


def sketch(commanded: Stream, seen: Stream, joint: int) -> tuple[str, ...]:
    """One joint (from 0) over time; empty if there is too little to draw.

    Each line is a range of values, the greatest at the top. Seen values are drawn over commanded ones.
    """
    points = {mark: _points(stream, joint) for mark, stream in ((_COMMANDED, commanded), (_SEEN, seen))}
    every = [point for some in points.values() for point in some]
    if not every:
        return ()
    (begin, end), (low, high) = (_range([point[axis] for point in every]) for axis in (0, 1))
    cells = [[" "] * _COLUMNS for _ in range(_ROWS)]
    for mark, some in points.items():
        for t, value in some:
            row = round((high - value) / (high - low) * (_ROWS - 1))
            cells[row][round((t - begin) / (end - begin) * (_COLUMNS - 1))] = mark
    middle = [high - row * (high - low) / (_ROWS - 1) for row in range(_ROWS)]
    return (
        f"joint {joint + 1} in rad, from {begin:.1f} s to {end:.1f} s: {_COMMANDED} commanded, {_SEEN} seen",
        *(f"{value:{_NUMBER}.2f} |{''.join(row)}".rstrip() for value, row in zip(middle, cells, strict=True)),
    )


def _points(stream: Stream, joint: int) -> list[tuple[float, float]]:
    return [(t, row[joint]) for t, row in zip(stream.times, stream.rows, strict=True) if len(row) > joint]


def _range(values: list[float]) -> tuple[float, float]:
    """The smallest and the greatest value, which differ."""
    low, high = min(values), max(values)
    return (low, high) if low < high else (low - 0.5, high + 0.5)

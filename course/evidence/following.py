"""How soon one stream shows what was commanded on another."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import inf, isclose

from course.evidence.stream import Row, Stream

_NEAR = 1e-6


@dataclass(frozen=True)
class Answer:
    """A command, and what came of it.

    sent: when (s). latency: seconds until a row that equals it; None when none did before the next command.
    last: the last row that came before the next one.
    """

    sent: float
    target: Row
    latency: float | None
    last: Row | None


def answers(commands: Stream, stream: Stream) -> tuple[Answer, ...]:
    """What came of each command, in their order."""
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
    """Whether both have the same joints, at the same places."""
    return len(one) == len(other) and all(
        isclose(a, b, rel_tol=near, abs_tol=near) for a, b in zip(one, other, strict=True)
    )


def alike(stream: Stream, near: float = _NEAR) -> bool:
    """Whether all joints make the same moves, wherever each of them is."""
    return all(_moved_alike(before, after, near) for before, after in pairwise(stream.rows))


def _moved_alike(before: Row, after: Row, near: float) -> bool:
    if len(before) != len(after):
        return False
    moves = [b - a for a, b in zip(before, after, strict=True)]
    return not moves or max(moves) - min(moves) <= near

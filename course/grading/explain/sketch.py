"""A stream beside what was commanded, drawn in a few lines of plain text: for the details of a feedback."""

from __future__ import annotations

from course.evidence.stream import Stream

_ROWS, _COLUMNS, _NUMBER = 7, 56, 7
_COMMANDED, _SEEN = "o", "#"


def sketch(commanded: Stream, seen: Stream, joint: int) -> tuple[str, ...]:
    """One joint (from 0) over time; empty where there is too little to draw.

    A line for each stretch of values, the greatest on top. What was seen covers what was commanded.
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
    """From the least to the greatest, which differ."""
    low, high = min(values), max(values)
    return (low, high) if low < high else (low - 0.5, high + 0.5)

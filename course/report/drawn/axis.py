"""The axis of time below a picture."""

from __future__ import annotations

from collections.abc import Callable

from course.report.drawn.glyphs import Glyphs
from course.report.pictures.svg import steps

_APART = 10  # columns at least from one number to the next


def column(end: float, width: int, begin: float = 0.0) -> Callable[[float], int]:
    """From seconds to a column, counted from 0; from `begin` to `end` is the whole width."""
    return lambda t: min(max(round((t - begin) / (end - begin) * (width - 1)), 0), width - 1)


def axis(end: float, width: int, glyphs: Glyphs, begin: float = 0.0) -> tuple[str, str]:
    """A line with ticks at round times, and the line with their seconds."""
    at = column(end, width, begin)
    ticks, numbers = [glyphs.bar] * width, [" "] * (width + 2)
    free = 0
    for t in steps(begin, end, max(width // _APART, 1)):
        text = f"{t:g} s"
        place = min(at(t), len(numbers) - len(text))
        ticks[at(t)] = glyphs.tick
        if place >= free:
            numbers[place : place + len(text)] = text
            free = place + len(text) + 1
    return "".join(ticks), "".join(numbers).rstrip()

"""A signal over time as text, with the band in which it should be."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from statistics import median

from rich.console import Console
from rich.text import Text

from course.report import sanitize
from course.report.console import put, put_prose
from course.report.pictures.glyphs import CURVES, LETTERS, Glyphs, axis, column, glyphs_for, row_of
from course.report.pictures.signals import Signal, window_of

ROWS = 8
_INDENT = "  "
_NUMBER = 9  # columns that a value takes on the left
_NARROWEST = 20
_LABEL, _NAME = 28, 60

Band = tuple[float, float]
_Cell = tuple[str, str]


def render_plot(console: Console, signal: Signal, duration: float, band: Band | None = None) -> None:
    """The signal over the time that `window_of` returns. band: where its median should be."""
    glyphs = glyphs_for(console)
    width = max(console.width - len(_INDENT) - _NUMBER - 5, _NARROWEST)
    begin, end = window_of(signal, duration)
    plot = _Plot(signal, column(end, width, begin), band, glyphs, width)
    unit = f" ({signal.unit})" if signal.unit else ""
    put_prose(console, Text(f"{signal.title}{unit}: {sanitize.one_line(signal.topic, _NAME)}", "bold"))
    for row in range(ROWS):
        put(console, plot.row(row))
    ticks, numbers = axis(end, width, glyphs, begin)
    margin = " " * (len(_INDENT) + _NUMBER + 2)
    put(console, f"{margin[:-1]}{glyphs.corner}{ticks}", "dim")
    put(console, f"{margin}{numbers}", "dim")
    for line in _legend(signal, band, glyphs):
        put_prose(console, line, first=_INDENT)


class _Plot:
    """Points by row and column; row 0 is at the top."""

    def __init__(
        self, signal: Signal, at: Callable[[float], int], band: Band | None, glyphs: Glyphs, width: int
    ) -> None:
        self._signal, self._band, self._glyphs, self._width = signal, band, glyphs, width
        self._lowest, self._highest = _range(signal, band)
        self._cells: dict[tuple[int, int], _Cell] = {}
        for place, curve in enumerate(signal.curves):
            for t, value in curve.points:
                self._cells[self._row_of(value), at(t)] = self._point(place, value)

    def row(self, row: int) -> Text:
        """One line of the plot, with its value on the left."""
        low, high = self._values(row)
        number = f"{(low + high) / 2:.3g}".rjust(_NUMBER)
        inside = self._band is not None and low < self._band[1] and high > self._band[0]
        empty = (self._glyphs.band, "dim green") if inside else (" ", "")
        drawn = row_of(self._cells.get((row, place), empty) for place in range(self._width))
        return Text.assemble(_INDENT, (f"{number} {self._glyphs.wall}", "dim"), drawn)

    def _point(self, place: int, value: float) -> _Cell:
        if self._band and not self._band[0] <= value <= self._band[1]:
            return self._glyphs.outside, "bold red"
        if len(self._signal.curves) == 1:
            return self._glyphs.point, "bold cyan"
        return LETTERS[place % len(LETTERS)], CURVES[place % len(CURVES)]

    def _row_of(self, value: float) -> int:
        share = (self._highest - value) / (self._highest - self._lowest)
        return min(max(int(share * ROWS), 0), ROWS - 1)

    def _values(self, row: int) -> Band:
        step = (self._highest - self._lowest) / ROWS
        return self._highest - (row + 1) * step, self._highest - row * step


def _range(signal: Signal, band: Band | None) -> Band:
    """The range of all values and the band, with some space around them. For seconds, it starts at zero."""
    values = [value for curve in signal.curves for _, value in curve.points] + list(band or ())
    lowest, highest = min(values), max(values)
    if signal.unit == "s":
        lowest = min(0.0, lowest)
    room = (highest - lowest) * 0.05 or abs(highest) * 0.1 or 1.0
    return (lowest if signal.unit == "s" else lowest - room), highest + room


def _legend(signal: Signal, band: Band | None, glyphs: Glyphs) -> Iterator[Text]:
    if band:
        words = f"expected {band[0]:.4g} to {band[1]:.4g}{_unit(signal)} (the median)"
        yield Text.assemble((glyphs.band * 2, "green"), f" {words}, ", (glyphs.outside, "red"), " outside")
    several = len(signal.curves) > 1
    for place, curve in enumerate(signal.curves):
        values = [value for _, value in curve.points]
        mark = (LETTERS[place % len(LETTERS)], CURVES[place % len(CURVES)]) if several else ("", "")
        told = (
            f"{sanitize.one_line(curve.label, _LABEL)}: {len(values)} values drawn, {min(values):.4g} to "
            f"{max(values):.4g}{_unit(signal)}, median {median(values):.4g}{_unit(signal)}"
        )
        yield Text.assemble(mark, " " if several else "", told)


def _unit(signal: Signal) -> str:
    return f" {signal.unit}" if signal.unit else ""

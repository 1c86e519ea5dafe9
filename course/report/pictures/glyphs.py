"""The characters of which pictures in the terminal consist, and the time axis below them."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from itertools import groupby
from operator import itemgetter

from rich.console import Console
from rich.text import Text

from course.report.pictures.svg import steps

# A curve's points: different curves can be distinguished without colors.
LETTERS = "abcdef"
# Colors of the terminal's own sixteen, one for each curve.
CURVES = ("cyan", "magenta", "yellow", "blue", "green", "red")


@dataclass(frozen=True)
class Glyphs:
    """Each is one column wide. moment: one message or call; many: ten or more in one place."""

    begin: str
    bar: str
    end: str
    flag: str
    line: str
    moment: str
    many: str
    band: str
    point: str
    outside: str
    tick: str
    corner: str
    wall: str
    arrow: str


_DRAWN = Glyphs("├", "─", "┤", "▼", "┴", "●", "█", "░", "●", "✕", "┬", "└", "│", "→")
_ASCII = Glyphs("[", "-", "]", "!", "'", "o", "#", ":", "o", "x", "+", "+", "|", ">")


def row_of(cells: Iterable[tuple[str, str]]) -> Text:
    """Glyphs, each with its style, as one text without spaces at its end."""
    text = Text()
    for style, run in groupby(cells, key=itemgetter(1)):
        text.append("".join(glyph for glyph, _ in run), style)
    text.rstrip()
    return text


def glyphs_for(console: Console) -> Glyphs:
    """Lines and dots if the terminal's encoding has them, else ASCII."""
    return _ASCII if console.options.ascii_only else _DRAWN


_APART = 10  # columns, at least, from one number to the next


def column(end: float, width: int, begin: float = 0.0) -> Callable[[float], int]:
    """A function from seconds to a column (from 0); `begin` to `end` is the whole width."""
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

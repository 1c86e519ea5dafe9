"""What pictures in the terminal are drawn with."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import groupby
from operator import itemgetter

from rich.console import Console
from rich.text import Text

# A curve's points, so that curves are told apart without colours.
LETTERS = "abcdef"
# Of the terminal's own sixteen, as many as there are curves.
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
    """Glyphs, each with its style, as one text that ends where nothing more is drawn."""
    text = Text()
    for style, run in groupby(cells, key=itemgetter(1)):
        text.append("".join(glyph for glyph, _ in run), style)
    text.rstrip()
    return text


def glyphs_for(console: Console) -> Glyphs:
    """Lines and dots where the terminal's encoding has them, else what every terminal has."""
    return _ASCII if console.options.ascii_only else _DRAWN

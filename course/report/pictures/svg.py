"""What all SVG pictures share: how numbers, texts and times are written, and how large one may become.

Every picture is one `<svg>` element without script, style or link. Its colors are attributes, so that it can
be viewed on its own; a page may set others by class. `<title>` and `<desc>` describe what it shows.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from html import escape
from typing import TypeVar

# Of one picture, which is drawn with less detail until it fits.
MOST_BYTES = 8 * 1024
WIDTH = 560
LEFT, RIGHT = 8, 12
DESC_LIMIT = 1500

Clean = Callable[[str], str]
_Level = TypeVar("_Level")


def number(value: float) -> str:
    """As short as possible: `12`, `3.5`."""
    return f"{value:.1f}".removesuffix(".0")


def element(key: str, height: float, title: str, desc: str, inner: Iterable[str]) -> str:
    """key: unique on the page. title and desc: plain text, clean."""
    told = desc if len(desc) <= DESC_LIMIT else f"{desc[: desc.rindex('.', 0, DESC_LIMIT) + 1]} And more."
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="pic" viewBox="0 0 {WIDTH} {number(height)}" '
        f'font-family="system-ui, sans-serif" font-size="12" role="img" '
        f'aria-labelledby="{key}t {key}d"><title id="{key}t">{escape(title)}</title>'
        f'<desc id="{key}d">{escape(told)}</desc>{"".join(inner)}</svg>'
    )


def text(x: float, y: float, words: str, *, cls: str = "label", anchor: str = "") -> str:
    at = f' text-anchor="{anchor}"' if anchor else ""
    fill = "#475569" if cls.startswith("axis") else "#0f172a"
    place = f'x="{number(x)}" y="{number(y)}"{at}'
    return f'<text class="{cls}" {place} fill="{fill}" stroke="none">{escape(words)}</text>'


def scale(end: float, begin: float = 0.0) -> Callable[[float], float]:
    """A function from seconds to x; `begin` to `end` is the whole width."""
    room = WIDTH - LEFT - RIGHT
    return lambda t: LEFT + min(max((t - begin) / (end - begin), 0.0), 1.0) * room


def steps(lowest: float, highest: float, most: int) -> Iterator[float]:
    """Round values from `lowest` to `highest`, at most `most` + 1."""
    span = highest - lowest
    if not (math.isfinite(span) and span > 0):
        return
    rough = span / most
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(power * factor for factor in (1, 2, 5, 10) if power * factor >= rough)
    place = math.ceil(lowest / step - 1e-9)
    while place * step <= highest + 1e-9 * span:
        yield place * step
        place += 1


def time_axis(end: float, top: float, bottom: float, begin: float = 0.0) -> Iterator[str]:
    """Thin lines at round times, with the seconds below."""
    x = scale(end, begin)
    at = list(steps(begin, end, 6))
    lines = "".join(f"M{number(x(t))} {number(top)}V{number(bottom)}" for t in at)
    yield f'<path class="grid" d="{lines}" stroke="#cbd5e1" fill="none"/>'
    for t in at:
        anchor = "start" if x(t) < 30 else "end" if x(t) > WIDTH - 30 else "middle"
        yield text(x(t), bottom + 14, f"{t:g} s", cls="axis", anchor=anchor)


def seconds(t: float) -> str:
    return f"{t:.2f} s" if t < 10 else f"{t:.1f} s"


def within_bounds(draw: Callable[[_Level], str], coarseness: Iterable[_Level]) -> str:
    """The first drawing that is small enough, else the last one. draw: its argument is a coarseness."""
    drawn = ""
    for each in coarseness:
        drawn = draw(each)
        if len(drawn.encode()) <= MOST_BYTES:
            break
    return drawn

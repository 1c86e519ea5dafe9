"""A signal over time as a picture."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain
from statistics import median

from course.model import replace
from course.report.pictures.signals import Curve, Points, Signal, window_of
from course.report.pictures.svg import (
    LEFT,
    RIGHT,
    WIDTH,
    Clean,
    element,
    number,
    scale,
    seconds,
    steps,
    text,
    time_axis,
    within_bounds,
)

_TOP, _HEIGHT, _FOOT = 24, 130, 22
_LABEL = 28
COLORS = ("#1d4ed8", "#b45309", "#0f766e", "#be185d", "#7c3aed", "#334155")
# To distinguish curves without colors.
_DASHES = ("", "6 3", "2 2", "8 2 2 2", "1 3", "12 4")
_POINTS = (320, 240, 160, 120, 80, 60, 40, 20)  # of a curve; fewer until the picture is small enough
_STRAIGHT = 0.4  # pixels; a point this close to a straight line is left out
_DOTS = 40  # if there are fewer points, dots are drawn, too


def plot(signal: Signal, duration: float, *, key: str, clean: Clean) -> str:
    """The picture, as one `<svg>` element of at most MOST_BYTES. key, clean: as for `timeline`."""
    named = replace(
        signal,
        topic=clean(signal.topic)[: 2 * _LABEL],
        curves=tuple(replace(curve, label=clean(curve.label)[:_LABEL]) for curve in signal.curves),
    )
    return within_bounds(lambda points: _drawn(named, duration, key, points), _POINTS)


def _drawn(signal: Signal, duration: float, key: str, points: int) -> str:
    lowest, highest = _range(signal)
    bottom = _TOP + _HEIGHT
    begin, end = window_of(signal, duration)
    x = scale(end, begin)

    def y(value: float) -> float:
        return bottom - (value - lowest) / (highest - lowest) * _HEIGHT

    inner = [*time_axis(end, _TOP, bottom, begin), *_value_axis(signal, lowest, highest)]
    for place, curve in enumerate(signal.curves):
        drawn = [(x(t), y(value)) for t, value in _thinned(curve.points, points)]
        inner.append(_line(drawn if len(drawn) <= _DOTS else _straightened(drawn), place))
    legend = list(_legend(signal.curves, bottom + _FOOT)) if len(signal.curves) > 1 else []
    only = signal.curves[0].label if len(signal.curves) == 1 and not signal.unit else ""
    what = f"{signal.topic}, {only}" if only else signal.topic
    title = f"{signal.title}, {what}"
    height = bottom + _FOOT + (18 * ((len(signal.curves) + 1) // 2) if legend else 0)
    unit = f" ({signal.unit})" if signal.unit else ""
    head = text(LEFT, 14, f"{signal.title}{unit}: {what}")
    return element(key, height, title, _told(signal), [head, *inner, *legend])


def _range(signal: Signal) -> tuple[float, float]:
    values = [value for curve in signal.curves for _, value in curve.points]
    lowest, highest = min(values), max(values)
    if signal.unit == "s":
        lowest = 0.0
    room = (highest - lowest) * 0.08 or abs(highest) * 0.1 or 1.0
    return (lowest if signal.unit == "s" else lowest - room), highest + room


def _value_axis(signal: Signal, lowest: float, highest: float) -> Iterator[str]:
    bottom = _TOP + _HEIGHT
    for value in steps(lowest, highest, 4):
        at = bottom - (value - lowest) / (highest - lowest) * _HEIGHT
        if at > _TOP + 8:
            yield (
                f'<path class="grid" d="M{LEFT} {number(at)}H{WIDTH - RIGHT}" stroke="#cbd5e1" fill="none"/>'
            )
            yield text(LEFT + 2, at - 3, f"{value:.6g}", cls="axis")


def _line(points: Sequence[tuple[float, float]], place: int) -> str:
    dash = f' stroke-dasharray="{_DASHES[place]}"' if _DASHES[place] else ""
    path = "L".join(f"{number(x)} {number(y)}" for x, y in points)
    line = f'<path d="M{path}" stroke-width="1.8"{dash}/>'
    if 2 < len(points) <= _DOTS:
        dots = "".join(f"M{number(x)} {number(y)}h0" for x, y in points)
        line += f'<path d="{dots}" stroke-width="5" stroke-linecap="round"/>'
    return f'<g class="c{place}" stroke="{COLORS[place]}" fill="none">{line}</g>'


def _legend(curves: Sequence[Curve], top: float) -> Iterator[str]:
    for place, curve in enumerate(curves):
        x, y = LEFT + (place % 2) * WIDTH / 2, top + 10 + (place // 2) * 18
        yield _line(((x, y - 4), (x + 26, y - 4)), place)
        yield text(x + 32, y, curve.label)


def _thinned(points: Points, most: int) -> Points:
    """Keep the lowest and the highest point of each section, so that no peak is lost."""
    if len(points) <= most:
        return points
    size = -(-len(points) * 2 // most)
    stretches = (points[at : at + size] for at in range(0, len(points), size))
    ends = ({min(part, key=_value), max(part, key=_value)} for part in stretches)
    return tuple(chain.from_iterable(sorted(each) for each in ends))


def _straightened(points: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """Drop points on a straight line between two kept points: a constant signal needs only two."""
    kept, waiting = [points[0]], [points[0]]
    for point in points[1:]:
        if any(_off(each, kept[-1], point) > _STRAIGHT for each in waiting[1:]):
            kept.append(waiting[-1])
            waiting = [waiting[-1]]
        waiting.append(point)
    return [*kept, points[-1]]


def _off(point: tuple[float, float], one: tuple[float, float], other: tuple[float, float]) -> float:
    """The vertical distance of the point from the line through the other two."""
    wide = other[0] - one[0]
    share = (point[0] - one[0]) / wide if wide else 0.0
    return abs(one[1] + share * (other[1] - one[1]) - point[1])


def _value(point: tuple[float, float]) -> float:
    return point[1]


def _told(signal: Signal) -> str:
    unit = f" {signal.unit}" if signal.unit else ""
    parts = []
    for curve in signal.curves:
        values = [value for _, value in curve.points]
        first, last = curve.points[0][0], curve.points[-1][0]
        parts.append(
            f"{curve.label}: {len(values)} values from {seconds(first)} to {seconds(last)}, "
            f"lowest {min(values):.4g}{unit}, highest {max(values):.4g}{unit}, "
            f"median {median(values):.4g}{unit}."
        )
    return " ".join(parts)

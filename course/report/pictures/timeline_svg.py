"""The timeline of a recording as a picture."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from course.evidence.recording import Recording
from course.report.pictures.lanes import Lane, Lanes, duration_of, lanes_of
from course.report.pictures.signal_svg import plot
from course.report.pictures.signals import signals_of
from course.report.pictures.svg import (
    LEFT,
    RIGHT,
    WIDTH,
    Clean,
    element,
    number,
    scale,
    text,
    time_axis,
    within_bounds,
)

NAMES = {
    "program": "program",
    "node": "node",
    "topic": "messages on",
    "sent": "sent by the grader to",
    "service": "calls of",
    "log": "log",
}
# Distinguishable for people with color blindness; each lane also names its kind.
COLORS = {
    "program": "#64748b",
    "node": "#0f766e",
    "topic": "#1d4ed8",
    "sent": "#7c3aed",
    "service": "#b45309",
    "log": "#be185d",
}
_LANE, _TRACK, _THICK = 36, 26, 10
_FOOT = 22
_FLAGS = 8
_LETTERS = 78  # that fit into a line
# Columns in which moments are drawn, and number of lanes: fewer of both, until the picture is small enough.
_COARSENESS = ((270, 40), (135, 40), (90, 20), (60, 14), (30, 10), (20, 6))
_ROOM = WIDTH - LEFT - RIGHT


def timeline(recording: Recording, *, key: str, clean: Clean) -> str | None:
    """The picture, as one `<svg>` element of at most MOST_BYTES; None if nothing happened.

    key: unique on the page, a word of letters and digits. clean: makes a submission's text safe to show.
    """
    lanes = lanes_of(recording, clean)
    if not lanes.lanes:
        return None
    return within_bounds(lambda level: _drawn(lanes.fewer(level[1]), key, level[0]), _COARSENESS)


def _drawn(lanes: Lanes, key: str, columns: int) -> str:
    top, bottom = 4, 4 + _LANE * len(lanes.lanes)
    more = not_drawn(lanes)
    inner = [*time_axis(lanes.duration, top, bottom)]
    for place, lane in enumerate(lanes.lanes):
        inner += _lane(lane, top + place * _LANE, lanes.duration, columns)
    height = bottom + _FOOT
    if more:
        inner.append(text(LEFT, height + 8, more, cls="axis"))
        height += 16
    told = " ".join([*(f"{named(lane)} {lane.words}" for lane in lanes.lanes), more]).strip()
    return element(key, height, "What happened, on one timeline", told, inner)


def named(lane: Lane) -> str:
    """The beginning of a lane's description."""
    name = f"{NAMES[lane.kind]} {lane.label}:"
    return name[0].upper() + name[1:]


def not_drawn(lanes: Lanes) -> str:
    """How many lanes of each kind are left out; empty if none is."""
    parts = [f'{count} more of "{NAMES[kind]}"' for kind, count in lanes.more.items()]
    return f"Not drawn: {', '.join(parts)}." if parts else ""


def _lane(lane: Lane, top: float, duration: float, columns: int) -> Iterator[str]:
    color = COLORS[lane.kind]
    count = f" ({len(lane.ticks)})" if lane.kind in ("topic", "sent", "service", "log") else ""
    yield text(LEFT, top + 13, f"{NAMES[lane.kind]} {lane.label}{count}")
    yield f'<g class="{lane.kind}" stroke="{color}" fill="{color}">'
    y = top + _TRACK
    if lane.spans:
        yield _bars(_merged(lane.spans, duration, columns), y)
    if lane.ticks and not (lane.spans and lane.kind == "service"):
        inside = lane.kind == "program"
        yield _ticks(lane.ticks, duration, columns, y, inside=inside)
    yield from _flags(lane, duration, y)
    yield "</g>"


def _bars(runs: Iterable[tuple[float, float]], y: float) -> str:
    path = "".join(f"M{number(begin)} {number(y)}h{number(max(end - begin, 2))}" for begin, end in runs)
    return f'<path class="bar" d="{path}" stroke-width="{_THICK}" stroke-opacity=".55" fill="none"/>'


def _ticks(ticks: Sequence[float], duration: float, columns: int, y: float, *, inside: bool) -> str:
    """Draw moments in neighboring columns as one stroke."""
    width = _ROOM / columns
    x = scale(duration)
    filled = sorted({min(int((x(t) - LEFT) / width), columns - 1) for t in ticks})
    path = "".join(
        f"M{number(LEFT + first * width)} {number(y)}h{number((last - first) * width + 1.6)}"
        for first, last in _runs(filled)
    )
    color = ' class="in" stroke="#0f172a"' if inside else ""
    return f'<path d="{path}" stroke-width="{_THICK - 6 if inside else _THICK}" fill="none"{color}/>'


def _runs(filled: Sequence[int]) -> Iterator[tuple[int, int]]:
    begin = last = None
    for column in filled:
        if begin is None or last is None or column > last + 1:
            if begin is not None and last is not None:
                yield begin, last
            begin = column
        last = column
    if begin is not None and last is not None:
        yield begin, last


def _merged(
    spans: Iterable[tuple[float, float]], duration: float, columns: int
) -> Iterator[tuple[float, float]]:
    x = scale(duration)
    gap = _ROOM / columns
    begin = end = None
    for since, until in sorted(spans):
        if begin is None or end is None or x(since) > end + gap:
            if begin is not None and end is not None:
                yield begin, end
            begin, end = x(since), x(until)
        end = max(end, x(until))
    if begin is not None and end is not None:
        yield begin, end


def _flags(lane: Lane, duration: float, y: float) -> Iterator[str]:
    if not lane.marks:
        return
    x = scale(duration)
    path = "".join(f"M{number(x(t))} {number(y - 8)}v16" for t, _ in lane.marks[-_FLAGS:])
    yield f'<path class="flag" d="{path}" stroke="#b91c1c" stroke-width="2.5" fill="none"/>'
    words = [f"{word} {t:.1f} s" for t, word in lane.marks[-3:]]
    room = _LETTERS - len(NAMES[lane.kind]) - len(lane.label)
    while len(words) > 1 and len(", ".join(words)) > room:
        words.pop(0)
    yield text(WIDTH - RIGHT, y - _TRACK + 13, ", ".join(words), cls="axis flags", anchor="end")


def pictures(recording: Recording, *, key: str, clean: Clean) -> tuple[str, ...]:
    """The timeline and at most two signals, each an `<svg>` element.

    Nothing for a mystery: its recording contains the names to find out. key: unique on the page, a word of
    letters and digits. clean: makes a submission's text safe to show.
    """
    if recording.seed is not None or recording.acts:
        return ()
    line = timeline(recording, key=f"{key}l", clean=clean)
    if line is None:
        return ()
    duration = duration_of(recording)
    plots = (
        plot(signal, duration, key=f"{key}s{place}", clean=clean)
        for place, signal in enumerate(signals_of(recording))
    )
    return (line, *plots)

"""The timeline of a recording as text: a label and a track for each lane, and the seconds below."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import pairwise
from statistics import median

from rich.console import Console
from rich.text import Text

from course.evidence.recording import Recording
from course.evidence.topic_view import MIN_INTERVALS, hertz, seconds
from course.model.feedback import Pace
from course.model.result import CheckResult
from course.report import sanitize
from course.report.console import put, put_prose, with_code
from course.report.pictures.glyphs import Glyphs, axis, column, glyphs_for, row_of
from course.report.pictures.lanes import Lane, Lanes, Told, lanes_of
from course.report.pictures.timeline_svg import named, not_drawn
from course.report.verdict import comparison

STYLES = {
    "program": "",
    "node": "green",
    "topic": "cyan",
    "sent": "magenta",
    "service": "yellow",
    "log": "blue",
}
_WORDS = 300
_INDENT = "  "
_NARROWEST = 20


def render_line(console: Console, recording: Recording, told: Told) -> None:
    """What happened, with what was expected next to it; a sentence if nothing happened."""
    lanes = lanes_of(recording, sanitize.one_line)
    put(console, "What happened", "bold")
    if not lanes.lanes:
        put(console, f"{_INDENT}Nothing was recorded.")
        return
    drawing = _Drawing(console, lanes)
    for lane in lanes.lanes:
        _put_words(console, lane, told)
        drawing.put_track(lane)
    drawing.put_axis()
    _put_others(console, lanes, told)


def rate(times: tuple[float, ...]) -> str:
    """`one every 0.50 s (2 Hz)`; empty if there are too few messages to tell."""
    intervals = [later - earlier for earlier, later in pairwise(times)]
    if len(intervals) < MIN_INTERVALS:
        return ""
    middle = median(intervals)
    return f"one every {seconds(middle)} ({hertz(middle)})" if middle > 0 else "all at once"


def asked(pace: Pace) -> str:
    return f"{seconds(pace.shortest)} to {seconds(pace.longest)}"


def _put_words(console: Console, lane: Lane, told: Told) -> None:
    pace = told.pace(lane.label) if lane.kind == "topic" else None
    seen = rate(lane.ticks) if lane.kind == "topic" else ""
    text = Text.assemble((named(lane), "bold"), f" {sanitize.cut(lane.words, _WORDS)}")
    if seen:
        text.append(f" {seen[:1].upper()}{seen[1:]}.")
    if pace:
        text.append(f" Expected one every {asked(pace)}.", "bold")
    put_prose(console, text, rest=_INDENT)
    for check in told.of(lane):
        _put_failed(console, check)


def _put_failed(console: Console, check: CheckResult) -> None:
    assert check.feedback is not None
    parts = [f"{label} {text}" for label, text in comparison(check.feedback)]
    what = ", ".join(parts) or sanitize.paragraph(check.feedback.summary)
    text = with_code(console, f"{sanitize.paragraph(check.title)}: {what}")
    put_prose(console, Text.assemble(("no  ", "bold red"), text), first=_INDENT, rest=f"{_INDENT}    ")


def _put_others(console: Console, lanes: Lanes, told: Told) -> None:
    """List lanes that did not fit, and checks that name none of the lanes."""
    more = not_drawn(lanes)
    if more:
        put_prose(console, Text(more, "dim"), first=_INDENT)
    shown = {check.id for lane in lanes.lanes for check in told.of(lane)}
    others = [check for check in told.failed if check.id not in shown]
    if others:
        put(console)
        put(console, "Not as expected", "bold")
    for check in others:
        _put_failed(console, check)


class _Drawing:
    """Tracks below each other, with the same time scale."""

    def __init__(self, console: Console, lanes: Lanes) -> None:
        self._console = console
        self._glyphs = glyphs_for(console)
        self._duration = lanes.duration
        self._width = max(console.width - 2 * len(_INDENT), _NARROWEST)
        self._used: set[str] = set()

    def put_track(self, lane: Lane) -> None:
        cells = self._cells(lane)
        style = STYLES[lane.kind]
        self._used |= {glyph for glyph, _ in cells.values()}
        colored = {place: (glyph, own or style) for place, (glyph, own) in cells.items()}
        track = row_of(colored.get(place, (" ", "")) for place in range(self._width))
        put(self._console, Text.assemble(_INDENT, track) if track else "")

    def put_axis(self) -> None:
        ticks, numbers = axis(self._duration, self._width, self._glyphs)
        put(self._console, f"{_INDENT}{ticks}", "dim")
        put(self._console, f"{_INDENT}{numbers}", "dim")
        legend = ", ".join(words for glyph, words in _legend(self._glyphs) if glyph in self._used)
        if any(glyph.isdigit() for glyph in self._used):
            legend += ", 2 to 9 that many"
        put_prose(self._console, Text(legend, "dim"), first=_INDENT)

    def _cells(self, lane: Lane) -> dict[int, tuple[str, str]]:
        """Glyph and style by column. Later glyphs replace earlier ones."""
        glyphs, at = self._glyphs, column(self._duration, self._width)
        cells: dict[int, tuple[str, str]] = {}
        for begin, end in lane.spans:
            cells |= {place: (glyphs.bar, "") for place in range(at(begin), at(end) + 1)}
        if lane.kind in ("program", "node"):
            cells |= dict(self._ends(lane))
        for place, count in Counter(at(t) for t in lane.ticks).items():
            cells[place] = (glyphs.line if lane.kind == "program" else _counted(count, glyphs), "")
        for t, word in lane.marks:
            cells[at(t)] = (glyphs.end if word.startswith("ended") else glyphs.flag, "bold red")
        return cells

    def _ends(self, lane: Lane) -> Iterator[tuple[int, tuple[str, str]]]:
        at = column(self._duration, self._width)
        for begin, end in lane.spans:
            if lane.kind == "node" and end < self._duration:
                yield at(end), (self._glyphs.end, "")
            yield at(begin), (self._glyphs.begin, "")


def _counted(count: int, glyphs: Glyphs) -> str:
    return glyphs.moment if count == 1 else str(count) if count < 10 else glyphs.many


def _legend(glyphs: Glyphs) -> Iterator[tuple[str, str]]:
    yield glyphs.begin, f"{glyphs.begin} begins"
    yield glyphs.end, f"{glyphs.end} ends"
    yield glyphs.line, f"{glyphs.line} printed"
    yield glyphs.flag, f"{glyphs.flag} signal, command, or limit"
    yield glyphs.moment, f"{glyphs.moment} one"
    yield glyphs.many, f"{glyphs.many} ten or more"

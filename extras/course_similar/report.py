"""Similar pairs in the terminal: how similar, and the longest passage on both sides."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import islice, zip_longest

from rich.cells import cell_len
from rich.console import Console
from rich.text import Text

from course.report import sanitize
from course.report.console import put, put_prose, with_code
from course_similar.comparison import (
    NO_VERDICT,
    Comparison,
    Match,
    Pair,
    Passage,
    code_of,
    counted,
    headline,
    more_pairs,
    name_of,
    place_of,
    share_of,
    without,
)

PASSAGES = 1  # shown of each pair
LINES = 12  # shown of a passage
REMARKS = 10
INDENT = "    "
_BETWEEN = " | "


def render_similar(console: Console, comparison: Comparison) -> None:
    """All pairs, the most similar first, then what was left out. Works without color, and at 80 columns."""
    put_prose(console, Text(headline(comparison), "bold"))
    for number, pair in enumerate(comparison.pairs, 1):
        put(console)
        _put_pair(console, number, pair)
    if comparison.more:
        put_prose(console, with_code(console, more_pairs(comparison)))
    put(console)
    _put_ending(console, comparison)


def _put_pair(console: Console, number: int, pair: Pair) -> None:
    for mark, side in ((f"{number}.", pair.one), ("", pair.other)):
        name = Text.assemble((name_of(side), "bold"), f"  {share_of(side)}")
        put(console, Text.assemble(mark.ljust(len(INDENT)), name))
    for match in pair.matches[:PASSAGES]:
        _put_match(console, match)
    more = len(pair.matches) - PASSAGES + pair.more
    if more > 0:
        put(console, Text(f"{INDENT}and {counted(more, 'shorter passage')}", "dim"))


def _put_match(console: Console, match: Match) -> None:
    """Both sides next to each other, with each line cut to half of the width."""
    width = (console.width - len(INDENT) - len(_BETWEEN)) // 2
    one, other = (Text(_end_of(place_of(side), width), "cyan") for side in (match.one, match.other))
    _put_row(console, one, other, width)
    rows = zip_longest(_code(match.one), _code(match.other), fillvalue=Text())
    for left, right in islice(rows, LINES):
        _put_row(console, left, right, width)
    longest = max(len(match.one.lines), len(match.other.lines))
    if longest > LINES:
        put(console, Text(f"{INDENT}{counted(longest - LINES, 'more line')}", "dim"))


def _end_of(place: str, width: int) -> str:
    """Keep the end, which says more than the beginning."""
    while cell_len(place) > width:
        place = "..." + place[4 if place.startswith("...") else 1 :]
    return place


def _put_row(console: Console, one: Text, other: Text, width: int) -> None:
    one, other = one.copy(), other.copy()
    one.truncate(width, overflow="ellipsis", pad=True)
    other.truncate(width, overflow="ellipsis")
    put(console, Text.assemble(INDENT, one, (_BETWEEN, "dim"), other))


def _code(passage: Passage) -> Iterable[Text]:
    for number, line in code_of(passage):
        yield Text.assemble((f"{number:>4} ", "dim"), line)


def _put_ending(console: Console, comparison: Comparison) -> None:
    for text in filter(None, (without(comparison), *map(sanitize.paragraph, comparison.remarks[:REMARKS]))):
        put_prose(console, Text(text, "dim"), first="Note: ")
    more = len(comparison.remarks) - REMARKS
    if more > 0:
        put(console, Text(f"Note: {counted(more, 'more remark')}", "dim"))
    if comparison.pairs:
        put_prose(console, NO_VERDICT)

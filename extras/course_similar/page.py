"""Similar pairs as one HTML page: without scripts or downloads, and with every text escaped."""

from __future__ import annotations

from collections.abc import Iterator
from html import escape

from course.report import sanitize
from course_similar.comparison import (
    NO_VERDICT,
    Comparison,
    Match,
    Pair,
    Passage,
    Side,
    code_of,
    counted,
    headline,
    more_pairs,
    name_of,
    place_of,
    share_of,
    without,
)

_STYLE = """
:root { color-scheme: light dark; }
body { font: 1rem/1.5 system-ui, sans-serif; max-width: 90rem; margin: 2rem auto; padding: 0 1rem; }
section { border-top: 1px solid #8888; margin-top: 2rem; }
.both { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem; margin: 1rem 0; }
.both > div { min-width: 0; }
h3 { font: 0.85rem ui-monospace, monospace; margin: 0 0 0.25rem; overflow-wrap: anywhere; }
pre { font: 0.85rem/1.4 ui-monospace, monospace; margin: 0; padding: 0.5rem; overflow-x: auto;
  background: #8882; }
pre b { font-weight: normal; opacity: 0.5; user-select: none; }
ol { padding-left: 2rem; }
"""
# A submission's text could do nothing here, even if it were not escaped.
_POLICY = "default-src 'none'; style-src 'unsafe-inline'"


def page(comparison: Comparison) -> Iterator[str]:
    """The page, piece by piece."""
    yield (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">\n'
        '<meta name="viewport" content="width=device-width">\n<meta name="robots" content="noindex">\n'
        f"<title>Similar submissions</title>\n<style>{_STYLE}</style>\n</head>\n<body>\n"
        f"<h1>Similar submissions</h1>\n<p>{escape(headline(comparison))}</p>\n"
        f"<p>{escape(NO_VERDICT)}</p>\n"
    )
    yield from _contents(comparison)
    for number, pair in enumerate(comparison.pairs, 1):
        yield from _pair(number, pair)
    yield from _notes(comparison)
    yield "</body>\n</html>\n"


def _contents(comparison: Comparison) -> Iterator[str]:
    yield "<ol>\n"
    for number, pair in enumerate(comparison.pairs, 1):
        yield f'<li><a href="#pair-{number}">{_side(pair.one)} and {_side(pair.other)}</a></li>\n'
    yield "</ol>\n"


def _side(side: Side) -> str:
    return escape(f"{name_of(side)} ({share_of(side)})")


def _pair(number: int, pair: Pair) -> Iterator[str]:
    yield f'<section id="pair-{number}">\n<h2>{number}. {_side(pair.one)}<br>{_side(pair.other)}</h2>\n'
    for match in pair.matches:
        yield from _match(match)
    if pair.more:
        yield f"<p>{counted(pair.more, 'shorter passage')} not shown.</p>\n"
    yield "</section>\n"


def _match(match: Match) -> Iterator[str]:
    yield '<div class="both">\n'
    yield from map(_passage, (match.one, match.other))
    yield "</div>\n"


def _passage(passage: Passage) -> str:
    lines = "\n".join(f"<b>{number:>4} </b>{escape(line)}" for number, line in code_of(passage))
    return f"<div><h3>{escape(place_of(passage))}</h3>\n<pre>{lines}</pre></div>\n"


def _notes(comparison: Comparison) -> Iterator[str]:
    if comparison.more:
        yield f"<p>{escape(more_pairs(comparison))}</p>\n"
    for text in filter(None, (without(comparison), *map(sanitize.paragraph, comparison.remarks))):
        yield f"<p>Note: {escape(text)}</p>\n"

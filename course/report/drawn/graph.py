"""Nodes and topics as they were seen: who publishes, who listens, and names that may be slips."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain

from rich.console import Console
from rich.text import Text

from course.evidence.recording import Recording
from course.report import safe
from course.report.console import put, put_prose
from course.report.drawn.connections import Connection, services_of, slips, topics_of
from course.report.drawn.glyphs import Glyphs, glyphs_for
from course.report.drawn.told import Told

MOST = 20
_ENDS = 6
_NAME = 60
_NOBODY = "nobody"
_SLIP = "bold red"


def render_graph(console: Console, recording: Recording, told: Told) -> None:
    """A line for each topic and service: `publishers -> topic -> subscriptions`. Needs no colour."""
    topics, services = topics_of(recording, told.names()), services_of(recording)
    if not topics and not services:
        put_prose(console, Text("No topic and no service was seen.", "dim"))
        return
    for title, some in (
        ("Who publishes, and who listens", topics),
        ("Who asks a service, and who answers", services),
    ):
        if some:
            put(console, title, "bold")
            _put_all(console, some)


def _put_all(console: Console, connections: Sequence[Connection]) -> None:
    pairs = list(slips(connections))
    marked = set(chain.from_iterable(pairs))
    first = sorted(connections, key=lambda one: one.name not in marked)[:MOST]
    glyphs = glyphs_for(console)
    for one in (one for one in connections if one in first):
        _put(console, one, glyphs, slip=one.name in marked)
    if len(connections) > len(first):
        put(console, f"  ... {len(connections) - len(first)} more ...", "dim")
    for one_name, other in pairs:
        names = f"{safe.one_line(one_name, _NAME)} and {safe.one_line(other, _NAME)}"
        text = Text(f"{names} are nearly alike, and each lacks what the other has: is one a slip?", _SLIP)
        put_prose(console, text, first="! ")


def _put(console: Console, one: Connection, glyphs: Glyphs, *, slip: bool) -> None:
    arrow = (f" {glyphs.bar}{glyphs.arrow} ", "dim")
    name = (safe.one_line(one.name, _NAME), _SLIP if slip else "bold cyan")
    line = Text.assemble(_end(one.givers), arrow, name, arrow, _end(one.takers))
    put_prose(console, line, first="! " if slip else "  ", rest="      ")


def _end(names: Sequence[str]) -> Text:
    if not names:
        return Text(_NOBODY, "bold yellow")
    shown = ", ".join(safe.one_line(name, _NAME) for name in names[:_ENDS])
    return Text(f"{shown} and {len(names) - _ENDS} more" if len(names) > _ENDS else shown)

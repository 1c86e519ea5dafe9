"""Nodes and topics as they were seen: who publishes, who listens, and names that may be misspelled."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import chain

from rich.console import Console
from rich.text import Text

from course.evidence.recording import Recording
from course.model.events import Joined, MessageSeen, MessageSent, ServiceCalled
from course.model.graph import infrastructure
from course.report import sanitize
from course.report.console import put, put_prose
from course.report.pictures.glyphs import Glyphs, glyphs_for
from course.report.pictures.lanes import Told
from course.spelling import nearest

GRADER = "the grader"
SOMEBODY = "somebody"  # a node whose name was not discovered
_COMPARED = 60  # names, at most: comparing all pairs takes time


@dataclass
class _Ends:
    givers: set[str] = field(default_factory=set)
    takers: set[str] = field(default_factory=set)


@dataclass(frozen=True)
class Connection:
    """A topic with its publishers and subscriptions, or a service with its clients and servers."""

    name: str
    givers: tuple[str, ...]
    takers: tuple[str, ...]

    @property
    def is_lonely(self) -> bool:
        """Whether there is nobody at one end."""
        return not (self.givers and self.takers)


def topics_of(recording: Recording, expected: Iterable[str] = ()) -> tuple[Connection, ...]:
    """Sorted by name. expected: names of topics to list, even if there are only similar ones."""
    ends: defaultdict[str, _Ends] = defaultdict(_Ends)
    for endpoint in recording.seen_endpoints():
        side = ends[endpoint.topic].givers if endpoint.kind == "publisher" else ends[endpoint.topic].takers
        side.add(endpoint.node or SOMEBODY)
    for topic, gives in _of_ours(recording):
        (ends[topic].givers if gives else ends[topic].takers).add(GRADER)
    nodes_and_services = {*recording.seen_nodes(), *(one.name for one in recording.seen_graph().services)}
    seen = tuple(ends)
    for name in set(expected) - nodes_and_services:
        if nearest(name, seen):
            ends[name]  # with nobody at its ends
    return _sorted(ends)


def services_of(recording: Recording) -> tuple[Connection, ...]:
    """Sorted by name: clients are givers, servers are takers."""
    ends: defaultdict[str, _Ends] = defaultdict(_Ends)
    for service in recording.seen_graph().services:
        ends[service.name].givers.update(name or SOMEBODY for name in service.clients)
        ends[service.name].takers.update(name or SOMEBODY for name in service.servers)
    for event in recording.events:
        if isinstance(event, ServiceCalled):
            ours = ends[event.service].givers if event.side == "client" else ends[event.service].takers
            ours.add(GRADER)
    return _sorted(ends)


def slips(connections: Iterable[Connection]) -> Iterator[tuple[str, str]]:
    """Pairs of similar names, each of which lacks the end that the other has."""
    lonely = [one for one in connections if one.is_lonely][:_COMPARED]
    for place, one in enumerate(lonely):
        others = [other.name for other in lonely[place + 1 :] if _complete(one, other)]
        close = nearest(one.name, others)
        if close:
            yield one.name, close


def _complete(one: Connection, other: Connection) -> bool:
    """Whether the two together could be one connection with both ends."""
    ends = {bool(one.givers), bool(other.givers)}, {bool(one.takers), bool(other.takers)}
    empty = [not (each.givers or each.takers) for each in (one, other)]
    return sum(empty) == 1 or ends == ({True, False}, {True, False})


def _of_ours(recording: Recording) -> Iterator[tuple[str, bool]]:
    """Topics on which the grader publishes (True) or listens."""
    for event in recording.events:
        if isinstance(event, MessageSeen | MessageSent):
            yield event.topic, isinstance(event, MessageSent)
        elif isinstance(event, Joined):
            yield event.topic, event.end == "publisher"


def _sorted(ends: dict[str, _Ends]) -> tuple[Connection, ...]:
    return tuple(
        Connection(name, tuple(sorted(both.givers)), tuple(sorted(both.takers)))
        for name, both in sorted(ends.items())
        if not infrastructure(name)
    )


MOST = 20
_ENDS = 6
_NAME = 60
_NOBODY = "nobody"
_SLIP = "bold red"


def render_graph(console: Console, recording: Recording, told: Told) -> None:
    """A line for each topic and service: `publishers -> topic -> subscriptions`. Needs no color."""
    topics, services = topics_of(recording, told.names()), services_of(recording)
    if not topics and not services:
        put_prose(console, Text("No topics or services were seen.", "dim"))
        return
    for title, some in (
        ("Who publishes, and who listens", topics),
        ("Who calls a service, and who answers", services),
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
        names = f"{sanitize.one_line(one_name, _NAME)} and {sanitize.one_line(other, _NAME)}"
        text = Text(f"{names} are nearly alike, and each lacks what the other has: is one a typo?", _SLIP)
        put_prose(console, text, first="! ")


def _put(console: Console, one: Connection, glyphs: Glyphs, *, slip: bool) -> None:
    arrow = (f" {glyphs.bar}{glyphs.arrow} ", "dim")
    name = (sanitize.one_line(one.name, _NAME), _SLIP if slip else "bold cyan")
    line = Text.assemble(_end(one.givers), arrow, name, arrow, _end(one.takers))
    put_prose(console, line, first="! " if slip else "  ", rest="      ")


def _end(names: Sequence[str]) -> Text:
    if not names:
        return Text(_NOBODY, "bold yellow")
    shown = ", ".join(sanitize.one_line(name, _NAME) for name in names[:_ENDS])
    return Text(f"{shown} and {len(names) - _ENDS} more" if len(names) > _ENDS else shown)

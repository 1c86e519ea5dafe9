"""Who gives and who takes on each topic and service of a recording, and names that are nearly alike."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from course.evidence.events import Joined, MessageSeen, MessageSent, ServiceCalled
from course.evidence.graph import infrastructure
from course.evidence.recording import Recording
from course.grading.explain.names import nearest

GRADER = "the grader"
SOMEBODY = "somebody"  # whose name discovery did not bring
_COMPARED = 60  # names: each with each takes its time


@dataclass
class _Ends:
    givers: set[str] = field(default_factory=set)
    takers: set[str] = field(default_factory=set)


@dataclass(frozen=True)
class Connection:
    """A topic with its publishers and subscriptions, or a service with who asks and who answers."""

    name: str
    givers: tuple[str, ...]
    takers: tuple[str, ...]

    @property
    def is_lonely(self) -> bool:
        """Whether one end of it is missing."""
        return not (self.givers and self.takers)


def topics_of(recording: Recording, expected: Iterable[str] = ()) -> tuple[Connection, ...]:
    """By name. expected: names of topics that were to be there, whether anybody was or not."""
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
            ends[name]  # nobody is there
    return _sorted(ends)


def services_of(recording: Recording) -> tuple[Connection, ...]:
    """By name: clients ask, servers answer."""
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
    """Pairs of names that are nearly alike, of which each lacks what the other has."""
    lonely = [one for one in connections if one.is_lonely][:_COMPARED]
    for place, one in enumerate(lonely):
        others = [other.name for other in lonely[place + 1 :] if _complete(one, other)]
        close = nearest(one.name, others)
        if close:
            yield one.name, close


def _complete(one: Connection, other: Connection) -> bool:
    """Whether both together would be whole; where nobody is on one, whoever is on the other may be meant."""
    ends = {bool(one.givers), bool(other.givers)}, {bool(one.takers), bool(other.takers)}
    empty = [not (each.givers or each.takers) for each in (one, other)]
    return sum(empty) == 1 or ends == ({True, False}, {True, False})


def _of_ours(recording: Recording) -> Iterator[tuple[str, bool]]:
    """Topics on which the grader itself publishes (True) or listens."""
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

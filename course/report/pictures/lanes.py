"""What happened, sorted into lanes of one timeline: programs, nodes, topics, services, logs.

It shows only what the learner's programs did, and when. It leaves out everything that would give an answer
away: a mystery's seed, the questions about it, and the contents of messages and files.
"""

from __future__ import annotations

import re
import signal
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import islice

from course.evidence.recording import Recording
from course.model import replace
from course.model.events import (
    GraphSeen,
    Joined,
    LimitReached,
    MessageSeen,
    MessageSent,
    OutputLine,
    ProcessExited,
    ProcessStarted,
    ServiceAnswered,
    ServiceCalled,
    ShellRan,
    SignalSent,
)
from course.model.feedback import Pace
from course.model.result import CheckResult, Outcome, Result
from course.report.pictures.signals import NOT_SHOWN
from course.report.pictures.svg import Clean, seconds
from course.spelling import counted

# This many lanes of each kind are drawn; the others are only counted.
MOST = {"program": 5, "node": 5, "topic": 6, "sent": 4, "service": 5, "log": 4}
_LABEL = 44
_LOG_LINES = 2000
_SIGNALS: dict[int, str] = {
    signal.SIGINT: "Ctrl+C",
    signal.SIGTERM: "SIGTERM",
    signal.SIGKILL: "SIGKILL",
    signal.SIGSEGV: "a crash",
}


@dataclass(frozen=True)
class Lane:
    """kind: a key of MOST. ticks: moments. spans: beginnings and ends. marks: moments, each with a word."""

    kind: str
    label: str
    words: str
    ticks: tuple[float, ...] = ()
    spans: tuple[tuple[float, float], ...] = ()
    marks: tuple[tuple[float, str], ...] = ()


@dataclass(frozen=True)
class Lanes:
    """more: how many lanes of each kind are left out."""

    lanes: tuple[Lane, ...]
    duration: float
    more: dict[str, int] = field(default_factory=dict)

    def fewer(self, most: int) -> Lanes:
        """At most `most` lanes, taken from all kinds in turn; the others are counted."""
        turn: Counter[str] = Counter()
        turns = []
        for lane in self.lanes:
            turn[lane.kind] += 1
            turns.append(turn[lane.kind])
        last = sorted(turns)[most - 1] if len(turns) > most else len(turns)
        kept = [lane for lane, place in zip(self.lanes, turns, strict=True) if place <= last][:most]
        gone = Counter(lane.kind for lane in self.lanes) - Counter(lane.kind for lane in kept)
        return Lanes(tuple(kept), self.duration, dict(Counter(self.more) + gone))


def duration_of(recording: Recording) -> float:
    """Seconds that a picture of the recording shows; never zero."""
    last = recording.events[-1].t if recording.events else 0.0
    return max(recording.duration, last, 0.001)


def lanes_of(recording: Recording, clean: Clean) -> Lanes:
    """clean: makes a submission's text safe to show."""
    duration = duration_of(recording)
    every = [
        *_programs(recording, duration),
        *_nodes(recording, duration),
        *_messages(recording, "topic", MessageSeen),
        *_messages(recording, "sent", MessageSent),
        *_services(recording, duration),
        *_logs(recording),
    ]
    shown, more = _few(every)
    return Lanes(tuple(replace(lane, label=_short(clean(lane.label))) for lane in shown), duration, more)


def _short(label: str) -> str:
    """Leave out the middle, because names of services differ at their ends."""
    half = _LABEL // 2 - 1
    return label if len(label) <= _LABEL else f"{label[:half]}…{label[-half:]}"


def _few(lanes: Iterable[Lane]) -> tuple[list[Lane], dict[str, int]]:
    count: Counter[str] = Counter()
    shown = []
    for lane in lanes:
        count[lane.kind] += 1
        if count[lane.kind] <= MOST[lane.kind]:
            shown.append(lane)
    return shown, {kind: have - MOST[kind] for kind, have in count.items() if have > MOST[kind]}


def _programs(recording: Recording, duration: float) -> Iterator[Lane]:
    begun = {event.process: event.t for event in recording.events if isinstance(event, ProcessStarted)}
    for name in dict.fromkeys(begun):
        marks = list(_marks(recording, name))
        ended = [event for event in recording.events if isinstance(event, ProcessExited)]
        end = next((event for event in ended if event.process == name), None)
        until = end.t if end else duration
        lines = tuple(e.t for e in recording.events if isinstance(e, OutputLine) and e.process == name)
        said = "; ".join(f"{word} at {seconds(t)}" for t, word in marks)
        printed = f" It printed {counted(len(lines), 'line')}." if lines else ""
        words = f"ran from {seconds(begun[name])} to {seconds(until)}{f' ({said})' if said else ''}.{printed}"
        yield Lane("program", name, words, lines, ((begun[name], until),), tuple(marks))


def _marks(recording: Recording, name: str) -> Iterator[tuple[float, str]]:
    for event in recording.events:
        if isinstance(event, SignalSent) and event.process == name:
            yield event.t, _SIGNALS.get(event.signal, f"signal {event.signal}")
        if isinstance(event, ProcessExited) and event.process == name:
            yield event.t, _end(event)
        if isinstance(event, LimitReached):
            yield event.t, f"out of {event.limit}"
        if isinstance(event, ShellRan) and event.process == name:
            yield event.t, "command"


def _end(event: ProcessExited) -> str:
    if event.signal is not None:
        return f"ended by {_SIGNALS.get(event.signal, f'signal {event.signal}')}"
    return "ended" if event.code == 0 else f"ended with {event.code}"


def _nodes(recording: Recording, duration: float) -> Iterator[Lane]:
    for name in recording.seen_nodes():
        spans = tuple(_presence(recording.graphs, name, duration))
        yield Lane("node", name, f"was there from {_spans(spans)}.", spans=spans)


def _presence(graphs: Sequence[GraphSeen], name: str, duration: float) -> Iterator[tuple[float, float]]:
    since: float | None = None
    for seen in graphs:
        here = name in seen.graph.nodes
        if here and since is None:
            since = seen.t
        elif not here and since is not None:
            yield since, seen.t
            since = None
    if since is not None:
        yield since, duration


def _messages(
    recording: Recording, kind: str, event_type: type[MessageSeen] | type[MessageSent]
) -> Iterator[Lane]:
    """Includes topics to which the grader listened without receiving anything."""
    times: defaultdict[str, list[float]] = defaultdict(list)
    for event in recording.events:
        if isinstance(event, Joined) and event.end == "subscription" and kind == "topic":
            times[event.topic]  # adds the topic, even if no message follows
        elif isinstance(event, event_type) and event.topic not in NOT_SHOWN:
            times[event.topic].append(event.t)
    for topic, at in times.items():
        words = f"{counted(len(at), 'message')}, {_from_to(at)}." if at else "none came."
        yield Lane(kind, topic, words, tuple(at))


def _services(recording: Recording, duration: float) -> Iterator[Lane]:
    """Each span is from a request to its response, or to the end if there was none."""
    answered = {event.call: event.t for event in recording.events if isinstance(event, ServiceAnswered)}
    spans: defaultdict[str, list[tuple[float, float]]] = defaultdict(list)
    for event in recording.events:
        if isinstance(event, ServiceCalled):
            spans[event.service].append((event.t, answered.get(event.call, duration)))
    for service, calls in spans.items():
        words = f"{counted(len(calls), 'call')}, {_from_to([call[0] for call in calls])}."
        yield Lane("service", service, words, tuple(call[0] for call in calls), tuple(calls))


def _logs(recording: Recording) -> Iterator[Lane]:
    lines: defaultdict[tuple[str, str], list[float]] = defaultdict(list)
    for line in islice(recording.log, _LOG_LINES):
        lines[line.node, line.level].append(line.t)
    for (node, level), at in lines.items():
        label = f"{level} {node}" if node else level
        yield Lane("log", label, f"{counted(len(at), 'line')}, {_from_to(at)}.", tuple(at))


def _spans(spans: Sequence[tuple[float, float]]) -> str:
    some = [f"{seconds(begin)} to {seconds(end)}" for begin, end in spans[:3]]
    return " and from ".join(some) + (" and later" if len(spans) > 3 else "")


def _from_to(at: Sequence[float]) -> str:
    return f"at {seconds(at[0])}" if len(at) == 1 else f"from {seconds(min(at))} to {seconds(max(at))}"


_TOPIC_NAME = re.compile(r"/\w[\w/]*")


@dataclass(frozen=True)
class Told:
    """What a result says about its recording: checks that failed, and the expected rates of messages."""

    failed: tuple[CheckResult, ...] = ()
    paces: tuple[Pace, ...] = ()

    @classmethod
    def by(cls, result: Result | None) -> Told:
        checks = result.checks if result else ()
        failed = tuple(check for check in checks if check.outcome is Outcome.FAILED and check.feedback)
        return cls(failed, tuple(check.pace for check in checks if check.pace))

    def pace(self, topic: str) -> Pace | None:
        return next((pace for pace in self.paces if pace.topic == topic), None)

    def of(self, lane: Lane) -> tuple[CheckResult, ...]:
        """Checks that name this lane's topic, service or node in what they expected or saw."""
        return tuple(check for check in self.failed if lane.label in _names(check))

    def names(self) -> tuple[str, ...]:
        """Topic names in what failed checks expected."""
        expected = (check.feedback.expected or "" for check in self.failed if check.feedback)
        return tuple(dict.fromkeys(name for text in expected for name in _TOPIC_NAME.findall(text)))


def _names(check: CheckResult) -> Iterator[str]:
    if check.feedback:
        for text in (check.feedback.expected, check.feedback.seen):
            yield from _TOPIC_NAME.findall(text or "")

"""More recordings to draw, beside those of tests/report/pictures."""

from __future__ import annotations

from course.evidence.recording import Recording
from course.model import events as kinds
from course.model.feedback import Feedback, Pace
from course.model.graph import Endpoint, Graph, Kind, Qos, Service
from course.model.result import CheckResult, Outcome, Result, Timing, Verdict
from tests.report.pictures.recordings import ADD, NUMBER, number, recording


def end(topic: str, kind: Kind, node: str) -> Endpoint:
    return Endpoint(topic, kind, node, NUMBER, "", Qos())


def graph(*endpoints: Endpoint, services: tuple[Service, ...] = ()) -> kinds.GraphSeen:
    nodes = tuple(sorted({one.node for one in endpoints if one.node}))
    return kinds.GraphSeen(0.5, Graph(nodes, endpoints, services))


# A node that publishes on /counteds where the grader listens on /counted.
TYPO = recording(
    kinds.Joined(0.1, "/counted", NUMBER, "subscription"),
    kinds.ProcessStarted(0.2, "counter", ("counter",)),
    graph(end("/counteds", "publisher", "/counter"), end("/rosout", "publisher", "/counter")),
    kinds.SignalSent(4.0, "counter", 2),
    kinds.ProcessExited(4.5, "counter", 0, None),
)
CALLS = recording(
    graph(
        end("/told", "subscription", "/adder"),
        services=(Service("/add", ADD, servers=("/adder",), clients=("/asker",)),),
    ),
    kinds.MessageSent(1.0, "/told", NUMBER, b""),
    kinds.ServiceCalled(1.0, "/add", ADD, "client", "1", "", b""),
)


def failed(expected: str | None, seen: str | None, title: str = "it publishes") -> CheckResult:
    feedback = Feedback("It does not.", expected=expected, seen=seen)
    return CheckResult(title, title, 1, Outcome.FAILED, feedback=feedback)


def judged(*checks: CheckResult, what: Recording | None = None) -> Result:
    timing = Timing(evidence=round(what.duration, 3) if what else 0.0)
    return Result("18-counter", Verdict.NOT_PASSED, checks, timing)


PACE = CheckResult("rate", "twice a second", 1, Outcome.PASSED, pace=Pace("/counted", 0.4, 0.6))


def steady(count: int, period: float = 0.5, topic: str = "/counted") -> list[kinds.MessageSeen]:
    return [number(place * period, place, topic) for place in range(count)]

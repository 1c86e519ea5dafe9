"""Expectations about the ROS graph: nodes, publishers, subscriptions and their types."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import convert

from course.errors import OurFault
from course.evidence.recording import Recording
from course.explain.languages import language_of
from course.explain.python_code import text_places
from course.explain.python_slips import made_again
from course.explain.setup_py import starts_another
from course.model.feedback import Failure, Feedback, Location
from course.model.graph import Endpoint, Kind, Qos, mismatch
from course.spelling import listed, nearest

_VERBS = {"publisher": "publishes on", "subscription": "subscribes to"}
_MAKERS = {"publisher": "create_publisher", "subscription": "create_subscription"}


def expect_node(recording: Recording, name: str, *, whole: bool = True) -> str:
    """Check that a node with this full name (`/talker`) appeared; unless `whole`, the name may contain more.

    Returns its full name.
    """
    nodes = recording.seen_nodes()
    found = next((one for one in nodes if (one == name if whole else name in one)), None)
    if found is not None:
        return found
    close = (nearest(name, nodes) if whole else None) or (nodes[0] if len(nodes) == 1 else None)
    other = starts_another(recording.sources, close, name.lstrip("/")) if close else None
    if whole:
        wanted, called, missing = name, f"not `{name}`", f"There is no node `{name}`."
    else:
        wanted, called = f"a name with `{name}` in it", f"its name should contain `{name}`"
        missing = f"There is no node whose name contains `{name}`."
    separator = ", " if whole else "; "
    raise Failure(
        Feedback(
            summary=f"The node is called `{close}`{separator}{called}." if close else missing,
            expected=wanted,
            seen=listed(nodes, "no node at all"),
            where=other.where if other else _name_places(recording, close) if close else (),
            advice=other.text if other else language_of(recording.sources).to_name_a_node(name.lstrip("/")),
        )
    )


def expect_endpoint(recording: Recording, kind: Kind, topic: str, *, remedy: str) -> None:
    """Check that `topic` (full name) has a publisher or subscription, and that no callback adds more."""
    if _on(recording, kind, topic):
        _expect_made_once(recording, kind, topic)
        return
    topics = recording.seen_graph().topics_of(kind)
    close = nearest(topic, topics)
    makers = language_of(recording.sources).places(recording.sources, _MAKERS[kind])
    if close:
        raise Failure(
            Feedback(
                summary=f"The node {_VERBS[kind]} `{close}`, not `{topic}`.",
                expected=topic,
                seen=close,
                where=_name_places(recording, close) or makers[:2],
                advice=f"Spell the topic's name exactly like this: `{topic.lstrip('/')}`.",
            )
        )
    raise Failure(
        Feedback(
            summary=f"No node {_VERBS[kind]} `{topic}`.",
            expected=f"a {kind} on {topic}",
            seen=f"the node {_VERBS[kind]} {listed(topics, 'no topic')}",
            where=makers[:2] or made_in(recording),
            advice=remedy,
        )
    )


def expect_type(recording: Recording, kind: Kind, topic: str, type_name: str) -> None:
    """Check that every publisher (or subscription) on `topic` has this type."""
    wrong = [endpoint for endpoint in _on(recording, kind, topic) if endpoint.type != type_name]
    if not wrong:
        return
    package, _, short = type_name.split("/")
    language = language_of(recording.sources)
    raise Failure(
        Feedback(
            summary=f"The {kind} on `{topic}` has the type `{wrong[0].type}`, not `{type_name}`.",
            expected=type_name,
            seen=wrong[0].type,
            where=language.places(recording.sources, _MAKERS[kind])[:2],
            advice=language.to_use_a_type(_MAKERS[kind], package, short),
        )
    )


def expect_qos(
    recording: Recording,
    topic: str,
    *,
    offered: Mapping[str, str | float] | None = None,
    requested: Mapping[str, str | float] | None = None,
) -> None:
    """Check that the learner's endpoints on `topic` (full name) match, so that messages arrive.

    offered: what a publisher offers; no subscription may ask for more. requested: what a subscription asks
    for; every publisher must offer it. With neither, subscriptions must match an ordinary publisher. Both
    map policies by their ROS names, such as `{"durability": "transient_local", "deadline": 0.5}` (s).
    Policies left out have the ROS defaults: reliable, volatile, automatic, no deadline. Raises OurFault for
    a policy that does not exist.
    """
    kind: Kind = "subscription" if requested is None else "publisher"
    other = _qos(offered or {} if requested is None else requested)
    for endpoint in _on(recording, kind, topic):
        own = endpoint.qos
        policy = mismatch(other, own) if kind == "subscription" else mismatch(own, other)
        if policy:
            raise Failure(_mismatch(recording, kind, policy, own, other))


_VALUES = {
    "reliability": ("reliable", "best_effort"),
    "durability": ("volatile", "transient_local"),
    "liveliness": ("automatic", "manual_by_topic"),
}


def _qos(policies: Mapping[str, str | float]) -> Qos:
    for name, value in policies.items():
        is_known = isinstance(value, int | float) if name == "deadline" else value in _VALUES.get(name, ())
        if not is_known:
            raise OurFault(f"there is no QoS policy {name}={value!r}")
    return convert(policies, Qos)


def _mismatch(recording: Recording, kind: Kind, policy: str, own: Qos, other: Qos) -> Feedback:
    wanted, seen, maker = getattr(other, policy), getattr(own, policy), _MAKERS[kind]
    comparison = (
        "publisher offers less than a subscription asks for"
        if kind == "publisher"
        else "subscription asks for more than the publisher offers"
    )
    if wanted == getattr(Qos(), policy):
        advice = f"Pass only the depth, `10`, to `{maker}`, or leave that policy at its default."
    else:
        advice = f"Pass a `QoSProfile` to `{maker}` whose `{policy}` is {_policy_value(wanted)}."
    return Feedback(
        summary=f"The {comparison} ({policy}), so no message arrives.",
        expected=f"{policy}: {_policy_value(wanted)}",
        seen=f"{policy}: {_policy_value(seen)}",
        where=language_of(recording.sources).places(recording.sources, maker)[:2],
        advice=advice,
    )


def _policy_value(value: object) -> str:
    if isinstance(value, float):
        return f"{value:g} s" if value else "none"
    return str(value)


def _on(recording: Recording, kind: Kind, topic: str) -> tuple[Endpoint, ...]:
    return tuple(e for e in recording.seen_endpoints() if e.topic == topic and e.kind == kind)


def _expect_made_once(recording: Recording, kind: Kind, topic: str) -> None:
    counts = (
        sum(one.topic == topic and one.kind == kind for one in seen.graph.endpoints)
        for seen in recording.graphs
    )
    most, cause = max(counts, default=0), made_again(recording.sources, _MAKERS[kind])
    if most > 2 and cause:
        raise Failure(
            Feedback(
                summary=f"There are {most} {kind}s on `{topic}`, and the number keeps growing.",
                expected=f"one {kind}",
                seen=f"{most} {kind}s",
                where=cause.where,
                advice=cause.text,
            )
        )


def made_in(recording: Recording) -> tuple[Location, ...]:
    """The constructor of the node, where publishers and the like belong."""
    sources = recording.sources
    found = (language_of(sources).places(sources, name) for name in ("__init__", "Node"))
    return tuple(place for places in found for place in places)[:1]


def _name_places(recording: Recording, topic: str) -> tuple[Location, ...]:
    plain = topic.lstrip("/")
    found = (text_places(recording.sources, f"{quote}{plain}{quote}") for quote in "'\"")
    slashed = (text_places(recording.sources, f"{quote}/{plain}{quote}") for quote in "'\"")
    return tuple(place for places in (*found, *slashed) for place in places)[:3]

"""Expectations about the ROS graph: nodes, publishers, subscriptions and their types."""

from __future__ import annotations

from course.evidence.recording import Recording
from course.explain.languages import language_of
from course.explain.python_code import text_places
from course.explain.python_slips import made_again, quoted_variable
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
    quoted = quoted_variable(recording.sources, _MAKERS[kind], topics)
    raise Failure(
        Feedback(
            summary=f"No node {_VERBS[kind]} `{topic}`.",
            expected=f"a {kind} on {topic}",
            seen=f"the node {_VERBS[kind]} {listed(topics, 'no topic')}",
            where=quoted.where
            if quoted
            else makers[:2] or language_of(recording.sources).constructor(recording.sources),
            advice=quoted.text if quoted else remedy,
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


def expect_qos(recording: Recording, topic: str) -> None:
    """Check that the learner's subscriptions on `topic` (full name) match an ordinary publisher."""
    for endpoint in _on(recording, "subscription", topic):
        policy, maker = mismatch(Qos(), endpoint.qos), _MAKERS["subscription"]
        if policy:
            raise Failure(
                Feedback(
                    summary=f"The subscription asks for more than the publisher offers ({policy}), "
                    "so no message arrives.",
                    expected=f"{policy}: {_policy_value(getattr(Qos(), policy))}",
                    seen=f"{policy}: {_policy_value(getattr(endpoint.qos, policy))}",
                    where=language_of(recording.sources).places(recording.sources, maker)[:2],
                    advice=f"Pass only the depth, `10`, to `{maker}`, or leave that policy at its default.",
                )
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


def _name_places(recording: Recording, topic: str) -> tuple[Location, ...]:
    plain = topic.lstrip("/")
    found = (text_places(recording.sources, f"{quote}{plain}{quote}") for quote in "'\"")
    slashed = (text_places(recording.sources, f"{quote}/{plain}{quote}") for quote in "'\"")
    return tuple(place for places in (*found, *slashed) for place in places)[:3]

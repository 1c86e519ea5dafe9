"""What is expected of the ROS graph: nodes, publishers, subscriptions, their types."""

from __future__ import annotations

from math import inf

from course.evidence.graph import Endpoint, Kind, Qos, mismatch
from course.evidence.recording import Recording
from course.feedback import Failure, Feedback, Location
from course.grading.explain.languages import language_of
from course.grading.explain.names import listed, nearest
from course.grading.explain.python_code import text_places

_VERBS = {"publisher": "publishes on", "subscription": "subscribes to"}
_MAKERS = {"publisher": "create_publisher", "subscription": "create_subscription"}


def expect_node(recording: Recording, name: str) -> None:
    """A node of this full name (`/print_forever`) was in the graph."""
    nodes = recording.seen_nodes()
    if name in nodes:
        return
    close = nearest(name, nodes) or (nodes[0] if len(nodes) == 1 else None)
    plain = name.lstrip("/")
    raise Failure(
        Feedback(
            summary=f"The node is called `{close}`, not `{name}`."
            if close
            else f"There is no node `{name}`.",
            expected=name,
            seen=listed(nodes, "no node at all"),
            where=_name_places(recording, close) if close else (),
            advice=language_of(recording.sources).to_name_a_node(plain),
        )
    )


def expect_node_called(recording: Recording, part: str) -> str:
    """A node whose name holds `part` was in the graph; its full name is returned."""
    nodes = recording.seen_nodes()
    if found := [name for name in nodes if part in name]:
        return found[0]
    close = nodes[0] if len(nodes) == 1 else None
    raise Failure(
        Feedback(
            summary=f"The node is called `{close}`; its name should hold `{part}`."
            if close
            else f"There is no node whose name holds `{part}`.",
            expected=f"a name with `{part}` in it",
            seen=listed(nodes, "no node at all"),
            where=_name_places(recording, close) if close else (),
            advice=language_of(recording.sources).to_name_a_node(part),
        )
    )


def expect_endpoint(recording: Recording, kind: Kind, topic: str, *, remedy: str) -> None:
    """Somebody publishes on, or subscribes to, `topic` (full name)."""
    if _on(recording, kind, topic):
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
                advice=f"Spell the topic's name `{topic.lstrip('/')}`, letter by letter.",
            )
        )
    raise Failure(
        Feedback(
            summary=f"No node {_VERBS[kind]} `{topic}`.",
            expected=f"a {kind} on {topic}",
            seen=f"the node {_VERBS[kind]} {listed(topics, 'no topic')}",
            where=makers[:2],
            advice=remedy,
        )
    )


def expect_type(recording: Recording, kind: Kind, topic: str, type_name: str) -> None:
    """Every publisher (or subscription) on `topic` has this type."""
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


def expect_same_definition(
    recording: Recording, kind: Kind, topic: str, type_name: str, type_hash: str, *, advice: str
) -> None:
    """The type of that name was built from the definition that the course knows.

    advice: says where the learner finds that definition.
    """
    for endpoint in _on(recording, kind, topic):
        if endpoint.type == type_name and endpoint.type_hash != type_hash:
            raise Failure(
                Feedback(
                    summary=f"Your `{type_name}` has other fields than the exercise asks for.",
                    advice=advice,
                )
            )


def expect_compatible_qos(recording: Recording, topic: str) -> None:
    """The subscriptions on `topic` match an ordinary publisher: reliable, volatile, no deadline."""
    makers = language_of(recording.sources).places(recording.sources, _MAKERS["subscription"])
    for endpoint in _on(recording, "subscription", topic):
        policy = mismatch(Qos(), endpoint.qos)
        if policy:
            offered, asked = getattr(Qos(), policy), getattr(endpoint.qos, policy)
            raise Failure(
                Feedback(
                    summary=f"The subscription asks for more than the publisher offers ({policy}), "
                    "so no message arrives.",
                    expected=f"{policy}: {_policy_value(offered)}",
                    seen=f"{policy}: {_policy_value(asked)}",
                    where=makers[:2],
                    advice="Give `create_subscription` just the depth, `10`, or leave that "
                    "policy at its default.",
                )
            )


def _policy_value(value: object) -> str:
    if isinstance(value, float):
        return "none" if value == inf else f"{value:g} s"
    return str(value)


def _on(recording: Recording, kind: Kind, topic: str) -> tuple[Endpoint, ...]:
    return tuple(e for e in recording.seen_endpoints() if e.topic == topic and e.kind == kind)


def _name_places(recording: Recording, topic: str) -> tuple[Location, ...]:
    plain = topic.lstrip("/")
    found = (text_places(recording.sources, f"{quote}{plain}{quote}") for quote in "'\"")
    slashed = (text_places(recording.sources, f"{quote}/{plain}{quote}") for quote in "'\"")
    return tuple(place for places in (*found, *slashed) for place in places)[:3]

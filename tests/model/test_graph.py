"""Which QoS policies keep two endpoints apart, and what a graph tells."""

from __future__ import annotations

import pytest

from course.model.graph import Endpoint, Graph, Qos, infrastructure, mismatch

STRING = "std_msgs/msg/String"


@pytest.mark.parametrize(
    ("offered", "asked", "policy"),
    [
        # Tables of the ROS 2 documentation, "Quality of Service settings", compatibilities.
        (Qos(), Qos(), None),
        (Qos("best_effort"), Qos("best_effort"), None),
        (Qos("reliable"), Qos("best_effort"), None),
        (Qos("best_effort"), Qos("reliable"), "reliability"),
        (Qos(durability="volatile"), Qos(durability="transient_local"), "durability"),
        (Qos(durability="transient_local"), Qos(durability="volatile"), None),
        (Qos(durability="transient_local"), Qos(durability="transient_local"), None),
        (Qos(liveliness="automatic"), Qos(liveliness="manual_by_topic"), "liveliness"),
        (Qos(liveliness="manual_by_topic"), Qos(liveliness="automatic"), None),
        (Qos(liveliness="manual_by_topic"), Qos(liveliness="manual_by_topic"), None),
        (Qos(deadline=0.0), Qos(deadline=1.0), "deadline"),
        (Qos(deadline=1.0), Qos(deadline=0.0), None),
        (Qos(deadline=1.0), Qos(deadline=1.0), None),
        (Qos(deadline=1.0), Qos(deadline=2.0), None),
        (Qos(deadline=2.0), Qos(deadline=1.0), "deadline"),
        # What a policy that is left to the middleware asks for is not known: no reason to blame.
        (Qos("system_default"), Qos(), None),
        (Qos(), Qos("best_available"), None),
        (Qos("best_effort", "volatile"), Qos("reliable", "transient_local"), "reliability"),
    ],
)
def test_mismatch(offered: Qos, asked: Qos, policy: str | None) -> None:
    assert mismatch(offered, asked) == policy


def test_a_graph_by_topic_and_kind() -> None:
    talker = Endpoint("/talk", "publisher", "/talker", STRING, "", Qos())
    listener = Endpoint("/talk", "subscription", "/listener", STRING, "", Qos())
    log = Endpoint("/rosout", "publisher", "/talker", "rcl_interfaces/msg/Log", "", Qos())
    graph = Graph(endpoints=(log, talker, listener))
    assert graph.publishers("/talk") == (talker,)
    assert graph.subscriptions("/talk") == (listener,)
    assert graph.publishers("/tal") == ()
    assert graph.topics_of("publisher") == ("/talk",)


@pytest.mark.parametrize(
    ("topic", "own"), [("/rosout", True), ("/parameter_events", True), ("/rosout_2", False), ("/talk", False)]
)
def test_topics_of_ros_itself(topic: str, own: bool) -> None:
    assert infrastructure(topic) is own

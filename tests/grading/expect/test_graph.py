"""Nodes, topics, types and QoS that a learner's graph should have."""

from __future__ import annotations

import pytest

from course.evidence.recording import Recording
from course.grading.expect.endpoints import (
    expect_endpoint,
    expect_node,
    expect_qos,
    expect_type,
)
from course.model.events import GraphSeen
from course.model.graph import Endpoint, Graph, Kind, Qos
from tests.golden import golden

from .conftest import QUOTE, TOPIC, record, said, told, where

HASH = "RIHS01_1"


def end(topic: str = TOPIC, kind: Kind = "publisher", type_name: str = QUOTE, **qos: object) -> Endpoint:
    return Endpoint(topic, kind, "/talker", type_name, HASH, Qos(**qos))  # type: ignore[arg-type]


def seen(*endpoints: Endpoint, nodes: tuple[str, ...] = ("/talker",), code: str = "") -> Recording:
    files = {"package.xml": "<name>taker</name> quotes", "setup.py": "'talker = talk.talker:main'"}
    return record(GraphSeen(1.0, Graph(nodes, endpoints)), GraphSeen(2.0, Graph()), code=code, files=files)


# nodes


def test_a_node_that_was_there_once_is_enough() -> None:
    assert said(expect_node, seen(), "/talker") is None


@pytest.mark.parametrize("nodes", [("/taker",), ("/other", "/taker")])
def test_a_misspelt_node(nodes: tuple[str, ...]) -> None:
    golden(told(expect_node, seen(nodes=nodes, code="\nsuper().__init__('taker')"), "/talker"))


def test_the_only_node_is_the_one_that_was_meant() -> None:
    golden(told(expect_node, seen(nodes=("/listener",)), "/talker"))


def test_no_node_at_all() -> None:
    golden(told(expect_node, seen(nodes=()), "/talker"))


def test_other_nodes_are_listed() -> None:
    golden(told(expect_node, seen(nodes=("/one", "/two")), "/talker"))


# topics

CODE = "\nself.create_publisher(Quote, '{}', 10)\nself.create_subscription(Quote, '{}', f, 10)\n"


@pytest.mark.parametrize("kind", ["publisher", "subscription"])
def test_an_endpoint_that_was_there_once_is_enough(kind: Kind) -> None:
    assert said(expect_endpoint, seen(end(kind=kind)), kind, TOPIC, remedy="make one") is None


@pytest.mark.parametrize("kind", ["publisher", "subscription"])
@pytest.mark.parametrize("written", ["amazing_qoutes", "/amazing_qoutes"])
def test_a_misspelt_topic(kind: Kind, written: str) -> None:
    recording = seen(end("/amazing_qoutes", kind), code=CODE.format(written, "other"))
    golden(told(expect_endpoint, recording, kind, TOPIC, remedy="make one"))


def test_a_misspelt_topic_that_is_written_nowhere() -> None:
    recording = seen(end("/amazing_qoutes"), code=CODE.replace("'{}'", "NAME"))
    assert where(told(expect_endpoint, recording, "publisher", TOPIC, remedy="")) == ["talk/talker.py:2"]


def test_no_endpoint_at_all() -> None:
    golden(told(expect_endpoint, seen(), "publisher", TOPIC, remedy="make one"))


def test_other_topics_are_listed_without_those_of_ros_itself() -> None:
    recording = seen(end("/rosout"), end("/parameter_events"), end("/b"), end("/a"))
    golden(told(expect_endpoint, recording, "publisher", TOPIC, remedy=""))


def test_the_other_end_of_the_topic_does_not_count() -> None:
    golden(told(expect_endpoint, seen(end()), "subscription", TOPIC, remedy=""))


# types


def test_the_right_type() -> None:
    assert said(expect_type, seen(end()), "publisher", TOPIC, QUOTE) is None


def test_one_wrong_type_among_two() -> None:
    recording = seen(end(), end(type_name="std_msgs/msg/String"), code=CODE)
    golden(told(expect_type, recording, "publisher", TOPIC, QUOTE))


def test_types_of_the_other_end_do_not_count() -> None:
    recording = seen(end(), end(kind="subscription", type_name="std_msgs/msg/String"))
    assert said(expect_type, recording, "publisher", TOPIC, QUOTE) is None


# QoS


def test_qos_that_matches() -> None:
    for qos in ({}, {"reliability": "best_effort"}, {"deadline": 0.0}):
        assert said(expect_qos, seen(end(kind="subscription", **qos)), TOPIC) is None


@pytest.mark.parametrize(
    "qos", [{"durability": "transient_local"}, {"liveliness": "manual_by_topic"}, {"deadline": 0.5}]
)
def test_qos_that_asks_for_too_much(qos: dict[str, object]) -> None:
    golden(told(expect_qos, seen(end(kind="subscription", **qos), code=CODE), TOPIC))


def test_qos_of_publishers_and_other_topics_does_not_count() -> None:
    others = (end(durability="transient_local"), end("/other", "subscription", durability="transient_local"))
    assert said(expect_qos, seen(*others), TOPIC) is None

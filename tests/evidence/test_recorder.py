"""The recorder on real ROS."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from course.isolation.levels import isolated

from .conftest import ros_python

pytestmark = pytest.mark.slow

LISTEN = Path(__file__).with_name("listen.py")


@pytest.fixture(scope="module")
def found() -> dict[str, Any]:
    with isolated(namespaces=False) as around:
        return dict(json.loads(ros_python(LISTEN, **around.environment)))


def test_messages_are_heard_whatever_qos_the_publisher_offers(found: dict[str, Any]) -> None:
    assert found["counts"] == {"/reliable": True, "/best_effort": True, "/early": True, "/flood": True}
    assert found["first"]
    assert found["one listener"]
    assert found["in time"]


def test_a_flood_is_cut(found: dict[str, Any]) -> None:
    assert found["cut"] == ["/flood"]
    assert found["kept of the flood"] == 5


def test_what_comes_at_once_is_all_taken_in_its_order(found: dict[str, Any]) -> None:
    assert found["burst"] == [*map(str, range(150)), "last"]


def test_a_closed_listener_hears_no_more(found: dict[str, Any]) -> None:
    assert found["after it was closed"] == ["before"]


def test_the_log_is_recorded(found: dict[str, Any]) -> None:
    assert found["logged"]
    assert ["robot.talker", "INFO", "häufig"] in found["log"]


def test_what_is_published_is_recorded_and_heard(found: dict[str, Any]) -> None:
    assert found["heard"] == [["arm", 5, 7]]
    assert found["sent"] == "arm"


def test_where_the_arena_itself_takes_part_is_recorded(found: dict[str, Any]) -> None:
    listened = [[name, "subscription"] for name in ("/reliable", "/best_effort", "/flood", "/early")]
    assert found["joined"] == [*listened, ["/header", "publisher"]]


def test_the_graph_is_without_the_recorder(found: dict[str, Any]) -> None:
    assert found["nodes"] == ["/robot/talker"]
    assert found["graphs"]


def test_a_graph_that_grows_without_end_is_watched_and_not_kept(found: dict[str, Any]) -> None:
    assert found["still looking"]
    assert found["graphs kept after the cut"] == 0


def test_an_unknown_type_is_our_fault(found: dict[str, Any]) -> None:
    for name in ("no_such_package/msg/String", "std_msgs/msg/Strin"):
        assert name in found[name]

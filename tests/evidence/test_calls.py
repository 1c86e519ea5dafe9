"""Services and parameters on real ROS: the recorder as client, as server, and what it keeps."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from course.isolation.levels import isolated

from .conftest import ros_python

pytestmark = pytest.mark.slow

CALL = Path(__file__).with_name("call.py")


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    folder = tmp_path_factory.mktemp("call")
    with isolated(namespaces=False) as around:
        return dict(json.loads(ros_python(CALL, str(folder / "call.mcap"), **around.environment)))


def test_what_is_loaded_is_what_was_recorded(found: dict[str, Any]) -> None:
    assert found["the same"]


def test_two_clients_ask_at_once(found: dict[str, Any]) -> None:
    assert found["before"] == [False, False]
    assert found["woken"] == [True, True]
    assert found["all answered"]
    assert found["counts"] == [4, 4, False]
    assert found["response"] == "häufig"
    assert found["calls"] == [["client 1", False, True, "häufig"], ["client 2", False, True, "häufig"]]
    assert found["clients"] == ["client 1", "client 2"]
    assert found["in order"]


def test_a_server_answers_falls_silent_and_answers_again(found: dict[str, Any]) -> None:
    assert (found["first answer"], found["second answer"], found["third answer"]) == (True, False, True)
    assert found["answers"] == ["answer 1", "answer 3"]
    assert found["requests"] == [
        ["/robot/talker", "answer 1"],
        ["/robot/talker", None],
        ["/robot/talker", "answer 3"],
    ]
    assert found["request times"]


def test_a_server_goes_and_comes_back(found: dict[str, Any]) -> None:
    assert found["gone"]
    assert found["back"]


def test_the_graph_has_the_services_of_others_only(found: dict[str, Any]) -> None:
    assert found["services"] == [
        ["/switch", "std_srvs/srv/SetBool", True, ["/robot/talker"], []],
        ["/trigger", "std_srvs/srv/Trigger", False, [], ["/robot/talker"]],
    ]


def test_parameters_with_type_and_value(found: dict[str, Any]) -> None:
    assert set(found["names"]) == {"quote", "period", "sizes", "use_sim_time"}
    assert found["at first"] == {
        "quote": ["string", "a"],
        "period": ["double", 0.5],
        "sizes": ["integer array", [1, 2]],
    }
    assert found["undeclared"] == ["qoute"]
    assert found["described"] == 4
    assert found["unasked"] == [False, False, True]


def test_parameters_that_are_set(found: dict[str, Any]) -> None:
    assert found["sets"][:2] == [
        ["quote", "string", "0.5", True, ""],
        ["period", "double", 2.0, False, "the period is fixed"],
    ]
    name, kind, value, successful, reason = found["sets"][2]
    assert (name, kind, value, successful) == ("not.there", "integer", 1, False)
    assert "undeclared parameter" in reason
    assert found["at last"] == "0.5"
    assert found["changes"] == [["quote", "string", "0.5"]]
    assert found["announced"]


def test_garbage_of_others_does_not_make_it_deaf(found: dict[str, Any]) -> None:
    assert found["still hears"]

"""RobotDriverROS: a driver of six joints, run with the tutorial's parameters."""

from __future__ import annotations

import math
from typing import Any

import pytest

from tests.underlay.sas.place import driver, ended, watched

pytestmark = pytest.mark.slow

DOUBLES, INTEGERS = "std_msgs/msg/Float64MultiArray", "std_msgs/msg/Int32MultiArray"
TOLD = {
    "/myrobot_1/get/joint_states": ["sensor_msgs/msg/JointState"],
    "/myrobot_1/get/joint_positions_min": [DOUBLES],
    "/myrobot_1/get/joint_positions_max": [DOUBLES],
    "/myrobot_1/get/home_states": [INTEGERS],
}
HEARD = {
    "/myrobot_1/set/target_joint_positions": [DOUBLES],
    "/myrobot_1/set/target_joint_velocities": [DOUBLES],
    "/myrobot_1/set/target_joint_forces": [DOUBLES],
    "/myrobot_1/set/homing_signal": [INTEGERS],
    "/myrobot_1/set/clear_positions": [INTEGERS],
}
POSITIONS = "set/target_joint_positions"
LIFE = ["connect 0", "initialize 0", "deinitialize 1", "disconnect 1"]


def calls(report: dict[str, Any]) -> list[str]:
    """The calls of the driver's life, each with the flag that its own loops look at."""
    lines = report["stdout"].splitlines()
    return [line.removeprefix("call ") for line in lines if line.startswith("call ")]


def errors(report: dict[str, Any]) -> list[str]:
    return [line for line in report["stderr"].splitlines() if line.startswith("[ERROR]")]


@pytest.fixture(scope="module")
def well() -> dict[str, Any]:
    """A driver that is listened to, commanded and interrupted."""
    one, other = [0.1 * joint for joint in range(6)], [-1.5] * 6
    return watched(
        driver(),
        ["hear", 250], ["graph"], ["command", POSITIONS, one], ["command", POSITIONS, other], ["interrupt"],
    )  # fmt: skip


def test_its_topics_and_their_types(well: dict[str, Any]) -> None:
    assert well["graph"] == [TOLD, HEARD]


def test_it_tells_500_times_per_second(well: dict[str, Any]) -> None:
    heard = well["heard"]
    # Wide, for a machine that is busy makes gaps; that the moments are exact is what test_core tells.
    assert 20 < (heard["number"] - 1) / heard["seconds"] < 1000


def test_limits_are_in_radians(well: dict[str, Any]) -> None:
    limits = [2 * math.pi] * 5 + [4 * math.pi]
    assert well["get/joint_positions_max"] == pytest.approx(limits)
    assert well["get/joint_positions_min"] == pytest.approx([-limit for limit in limits])
    assert well["get/home_states"] == [0] * 6


def test_it_goes_where_it_is_told(well: dict[str, Any]) -> None:
    one = [0.1 * joint for joint in range(6)]
    assert well["joint_states"] == [[0.0] * 6, one, [-1.5] * 6]


def test_an_interrupt_ends_it_in_order(well: dict[str, Any]) -> None:
    assert (calls(well), errors(well), well["code"]) == (LIFE, [], 0)
    assert well["stdout"].splitlines()[-1] == "returned 0"
    assert well["stderr"].splitlines()[-1].endswith("complaints after this line do no harm.")


def test_a_target_of_five_elements_ends_it_in_order() -> None:
    report = watched(driver(), ["hear", 1], ["command", POSITIONS, [0.0] * 5])
    assert calls(report) == LIFE
    assert [line.partition("::")[2] for line in errors(report)] == [
        "Robot driver: control loop failed: a target of another size"
    ]
    assert report["stdout"].splitlines()[-1] == "returned 1"


def test_what_a_robot_does_not_take_ends_it_in_order() -> None:
    report = watched(driver(), ["hear", 1], ["command", "set/target_joint_velocities", [1.0] * 6])
    assert calls(report) == LIFE
    assert "takes no target velocities" in errors(report)[0]


def test_homing_is_heard_and_not_passed_on() -> None:
    there = [0.5] * 6
    homing = ["say", "set/homing_signal", [1] * 6]
    report = watched(driver(), ["hear", 1], homing, ["command", POSITIONS, there], ["interrupt"])
    assert report["joint_states"][-1] == there
    assert errors(report) == []


@pytest.mark.parametrize(
    ("fails", "called", "said"),
    [
        ("connect", ["connect 0", *LIFE[2:]], "connect failed: the probe fails in connect"),
        ("initialize", LIFE, "initialize failed: the probe fails in initialize"),
        ("loop", LIFE, "control loop failed: it threw something that is no std::exception."),
    ],
)
def test_whatever_throws_it_is_left_in_order(fails: str, called: list[str], said: str) -> None:
    report = ended(driver(fail_in=fails))
    assert calls(report) == called
    assert [line.partition("::Robot driver: ")[2] for line in errors(report)] == [said]
    assert report["stdout"].splitlines()[-1] == "returned 1"


def test_it_is_disconnected_though_deinitialize_throws() -> None:
    report = watched(driver(fail_in="deinitialize"), ["hear", 1], ["interrupt"])
    assert calls(report) == LIFE
    assert "the probe fails in deinitialize" in errors(report)[0]


def test_a_list_can_be_given_as_empty() -> None:
    empty = ["EMPTY_LIST"]
    report = ended(driver(joint_limits_min=empty, joint_limits_max=empty, fail_in="connect"))
    assert "connect failed" in errors(report)[0]


@pytest.mark.parametrize(
    ("parameters", "said"),
    [
        ({"joint_limits_min": ["EMPTY_LIST", "x"]}, "The parameter joint_limits_min of the node myrobot_1"),
        ({"ip": None}, "The parameter ip of the node myrobot_1 must be set"),
        ({"joint_limits_max": "none"}, "The parameter joint_limits_max of the node myrobot_1"),
        ({"thread_sampling_time_sec": 0.0}, "the sampling time must be positive"),
    ],
)
def test_what_is_missing_or_wrong_is_named_before_anything_moves(
    parameters: dict[str, Any], said: str
) -> None:
    report = ended(driver(**parameters))
    assert calls(report) == []
    assert said in errors(report)[0]

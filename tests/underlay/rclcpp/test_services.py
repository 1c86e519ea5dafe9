"""Services: our rclcpp on one side, rclpy on the other."""

from __future__ import annotations

import pytest

from tests.underlay.rclcpp.room import Room

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("form", ["plain", "bound", "header", "later"])
def test_rclpy_is_answered(form: str, room: Room) -> None:
    with room.program("serving", form) as server, room.peer("call") as peer:
        server.until("ready")
        assert peer.until("on") == "True on\n"


@pytest.mark.parametrize("way", ["future", "shared", "callback"])
def test_rclpy_answers(way: str, room: Room) -> None:
    with room.peer("serve"):
        ended = room.run("serving", "call", way)
    assert ended.code == 0
    assert "[caller]: answer: on\n" in ended.text


def test_a_future_may_hold_the_request_too(room: Room) -> None:
    with room.peer("serve"):
        assert "answer: on to 1\n" in room.run("serving", "call", "request").text


def test_where_nobody_serves_waiting_ends(room: Room) -> None:
    said = room.run("serving", "call", "nobody").text
    assert "there: 0\n" in said
    assert "code: TIMEOUT (2) pending: 1\n" in said


def test_ros2_service_call(room: Room) -> None:
    with room.program("serving", "plain") as server:
        server.until("ready")
        called = room.ros2("service", "call", "/switch", "std_srvs/srv/SetBool", "{data: true}")
        listed = room.ros2("service", "list", "-t", "--no-daemon").text
    assert "std_srvs.srv.SetBool_Response(success=True, message='on')" in called.text
    assert "/server/get_type_description [type_description_interfaces/srv/GetTypeDescription]" in listed

"""Services: our rclcpp on one side, rclpy on the other."""

from __future__ import annotations

import pytest

from tests.underlay.rclcpp.room import Room

pytestmark = pytest.mark.slow


def test_rclpy_is_answered_by_callbacks_of_all_forms(room: Room) -> None:
    names = ["switch", "bound", "header", "later"]
    with room.program("serving", "serve"), room.peer("call", *names) as peer:
        assert peer.until("later").splitlines() == [f"{name} True on" for name in names]


def test_rclpy_answers_in_all_ways(room: Room) -> None:
    with room.peer("serve"):
        ended = room.run("serving", "call")
    assert ended.code == 0
    answers = [line.partition("[caller]: ")[2] for line in ended.text.splitlines()]
    assert answers == ["future: on", "shared: on", "callback: on", "generic: on", "request: on to 1"]


def test_where_nobody_serves_waiting_ends(room: Room) -> None:
    said = room.run("serving", "nobody").text
    assert "there: 0\n" in said
    assert "code: TIMEOUT (2) pending: 1\n" in said


def test_ros2_service_call(room: Room) -> None:
    with room.program("serving", "serve") as server:
        server.until("ready")
        called = room.ros2("service", "call", "/switch", "std_srvs/srv/SetBool", "{data: true}")
        listed = room.ros2("service", "list", "-t", "--no-daemon").text
    assert "std_srvs.srv.SetBool_Response(success=True, message='on')" in called.text
    assert "/server/get_type_description [type_description_interfaces/srv/GetTypeDescription]" in listed

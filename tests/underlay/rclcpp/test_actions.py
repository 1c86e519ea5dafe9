"""Actions: ours on one side, rclpy and `ros2` on the other. Alone: see probes/src/actions.cpp."""

from __future__ import annotations

import pytest

from tests.underlay.rclcpp.room import Room

pytestmark = pytest.mark.slow


def test_rclpy_asks(room: Room) -> None:
    with room.program("fibonacci", "serve"), room.peer("ask", "5", "101", "-1") as peer:
        said = peer.until("-1 5").splitlines()
    assert said == ["5 4 [0, 1, 1, 2, 3, 5]", "101 rejected", "-1 [0, 1] canceling 1", "-1 5 [0]"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("call", "7"), ["accepted", "code 4: 7"]),
        (("call", "101"), ["rejected"]),
        (("cancel", "-1"), ["accepted", "fed 4 2", "code 5: -1"]),
    ],
)
def test_rclpy_serves(words: tuple[str, ...], said: list[str], room: Room) -> None:
    with room.peer("act"):
        ended = room.run("fibonacci", *words)
    assert (ended.code, ended.text.splitlines()) == (0, said)


def test_ros2_action(room: Room) -> None:
    with room.program("fibonacci", "serve") as server:
        server.until("ready")
        sent = room.ros2(
            "action", "send_goal", "/fibonacci", "example_interfaces/action/Fibonacci", "{order: 3}"
        )
        ended = server.end()
    assert "Goal finished with status: SUCCEEDED" in sent.text
    assert ended.code == 0

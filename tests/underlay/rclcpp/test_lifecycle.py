"""A node with states in C++, and `ros2 lifecycle` that changes them: see probes/src/lifecycle.cpp."""

from __future__ import annotations

import pytest

from tests.underlay.rclcpp.room import Ended, Room

pytestmark = pytest.mark.slow


def test_it_is_led_through_its_life(room: Room) -> None:
    with room.program("lifecycle", "node") as started:
        while not room.ros2("lifecycle", "nodes").text:
            assert started.process.poll() is None
        for step in ("configure", "activate"):
            done = Ended(0, "Transitioning successful\n")
            assert room.ros2("lifecycle", "set", "managed", step) == done
        assert room.ros2("lifecycle", "get", "managed") == Ended(0, "active [3]\n")
        assert room.ros2("topic", "echo", "--once", "/topic") == Ended(0, "data: ''\n---\n")
        assert room.ros2("lifecycle", "set", "managed", "deactivate") == done
        listed = room.ros2("lifecycle", "list", "managed").text
        assert [line for line in listed.splitlines() if line.startswith("-")] == [
            "- cleanup [2]", "- activate [3]", "- shutdown [6]",
        ]  # fmt: skip
        assert room.ros2("lifecycle", "list", "-a", "managed").text.count("Start:") == 25
        unknown = room.ros2("lifecycle", "set", "managed", "configure")
        assert unknown.code == 1 and "- cleanup [2]" in unknown.text
        assert room.ros2("lifecycle", "set", "managed", "7").code == 1
        assert room.ros2("lifecycle", "set", "managed", "shutdown") == done
        text = started.end().text
    assert text.splitlines()[-4:] == [
        "configure unconfigured configuring",
        "activate inactive activating",
        "deactivate active deactivating",
        "shutdown inactive shuttingdown",
    ]

"""Parameters: from the command line, from files, through `ros2 param`, and as others are told of them."""

from __future__ import annotations

import pytest

from tests.underlay.rclcpp.room import Ended, Room

pytestmark = pytest.mark.slow
AT_ONCE = ["rate = 2.500000", "count = 3", "name = Ann", "numbers = [1, 2]"]


def shown(text: str) -> list[str]:
    """What the node has logged, without time and name."""
    return [line.split("[configured]: ")[1] for line in text.splitlines() if "[configured]: " in line]


def values(room: Room, *words: str) -> list[str]:
    """What the node has at its beginning, started with these words."""
    with room.program("parameters", "--ros-args", *words) as node:
        return shown(node.until("numbers ="))


def test_defaults(room: Room) -> None:
    assert values(room) == AT_ONCE


def test_the_command_line(room: Room) -> None:
    words = ("-p", "rate:=4.5", "-p", "numbers:=[3.0]", "-p", "configured:name:=Bob", "-p", "other:count:=9")
    assert values(room, *words) == ["rate = 4.500000", "count = 3", "name = Bob", "numbers = [3]"]


@pytest.mark.parametrize("node", ["configured", "/configured", "/**", "/*"])
def test_a_file(node: str, room: Room) -> None:
    file = room.folder / "parameters.yaml"
    others = "/x/configured:\n  ros__parameters: {rate: 1.0}\n"
    file.write_text(f"{node}:\n  ros__parameters: {{count: 7}}\n{others}")
    assert values(room, "--params-file", str(file)) == [AT_ONCE[0], "count = 7", *AT_ONCE[2:]]


def test_a_file_for_other_nodes_counts_for_nothing(room: Room) -> None:
    file = room.folder / "parameters.yaml"
    file.write_text("other: {ros__parameters: {count: 7}}\n/*/configured: {ros__parameters: {rate: 1.0}}\n")
    assert values(room, "--params-file", str(file)) == AT_ONCE


def test_a_value_of_another_type_is_refused_at_the_beginning(room: Room) -> None:
    ended = room.run("parameters", "--ros-args", "-p", "rate:=5")
    assert ended.code == 3
    assert (
        "[main]: parameter 'rate' has invalid type: Wrong parameter type, parameter {rate} is of type "
        "{double}, setting it to {integer} is not allowed.\n" in ended.text
    )


def test_ros2_param(room: Room) -> None:
    def param(verb: str, *words: str) -> Ended:
        return room.ros2("param", verb, "/configured", *words)

    with room.program("parameters") as node:
        node.until("numbers =")
        assert [line.strip() for line in param("list").text.splitlines()] == [
            "count", "fixed", "limited", "name", "numbers",
            *(f"qos_overrides./parameter_events.publisher.{p}"
              for p in ("depth", "durability", "history", "reliability")),
            "rate", "start_type_description_service", "use_sim_time",
        ]  # fmt: skip
        assert param("get", "rate").text == "Double value is: 2.5\n"
        assert param("set", "rate", "3.5").text == "Set parameter successful\n"
        assert shown(node.until("rate =")) == ["rate = 3.500000"]
        assert param("set", "rate", "-1.0").text == "Setting parameter failed: a rate is positive\n"
        described = param("describe", "limited").text
        assert "Description: from nought to ten" in described
        assert "Max value: 10" in described
        dumped = param("dump").text
        assert "    numbers:\n    - 1.0\n    - 2.0\n" in dumped
        assert "    rate: 3.5\n" in dumped


def test_changes_are_told(room: Room) -> None:
    with room.peer("events") as peer, room.program("parameters"):
        peer.until("listening")
        room.ros2("param", "set", "/configured", "rate", "3.5")
        peer.until("changed /configured rate 3.5\n")


def test_simulated_time(room: Room) -> None:
    with room.peer("clock"), room.program("parameters", "--ros-args", "-p", "use_sim_time:=true") as node:
        node.until("[configured]: simulated time: 42.5\n")


def test_time_may_become_simulated_later(room: Room) -> None:
    with room.peer("clock"), room.program("parameters") as node:
        node.until("numbers =")
        room.ros2("param", "set", "/configured", "use_sim_time", "true")
        node.until("[configured]: simulated time: 42.5\n")

"""Nodes in a shared library, each with a program of its own: see probes/src/components.cpp."""

from __future__ import annotations

import pytest

from tests.underlay.rclcpp.room import Room

pytestmark = pytest.mark.slow


@pytest.mark.parametrize(
    ("program", "code", "said"),
    [
        ("first", 0, "1 /space/renamed 2\n"),
        ("second", 0, "2 /space/renamed 2\n"),
        ("third", 1, "RCLCPP_COMPONENTS_REGISTER_NODE(probes::Third) is missing\n"),
    ],
)
def test_a_program_runs_its_component(program: str, code: int, said: str, room: Room) -> None:
    ended = room.run(program, "word", "--ros-args", "-r", "__ns:=/space", "-r", "__node:=renamed")
    assert ended.code == code
    assert said in ended.text

"""What needs no other node is checked in C++, case by case: see probes/src/units.cpp."""

from __future__ import annotations

import re

import pytest

from tests.underlay.rclcpp.room import PROBES, Room


def cases(program: str) -> list[str]:
    """The names of the cases in a program."""
    return re.findall(r'^    \{"(\w+)", ', (PROBES / "src" / f"{program}.cpp").read_text(), re.MULTILINE)


@pytest.mark.slow
@pytest.mark.parametrize("case", cases("units"))
def test_unit(case: str, room: Room) -> None:
    ended = room.run("units", case)
    assert ended.code == 0, ended.text


@pytest.mark.slow
@pytest.mark.parametrize("case", cases("executors"))
def test_executors(case: str, room: Room) -> None:
    ended = room.run("executors", case)
    assert ended.code == 0, ended.text


@pytest.mark.slow
@pytest.mark.parametrize("case", cases("further"))
def test_further(case: str, room: Room) -> None:
    ended = room.run("further", case)
    assert ended.code == 0, ended.text

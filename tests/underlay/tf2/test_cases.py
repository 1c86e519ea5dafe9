"""What is checked in C++, case by case: see probes/src."""

from __future__ import annotations

import re

import pytest

from tests.underlay.rclcpp.room import Room
from tests.underlay.tf2.conftest import PROBES


def cases(program: str) -> list[str]:
    """The names of the cases in a program."""
    return re.findall(r'^    \{"(\w+)", ', (PROBES / "src" / f"{program}.cpp").read_text(), re.MULTILINE)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("program", "case"),
    [(program, case) for program in ("frames", "conversions", "nodes") for case in cases(program)],
)
def test_case(program: str, case: str, room: Room) -> None:
    ended = room.run(program, case)
    assert ended.code == 0, ended.text

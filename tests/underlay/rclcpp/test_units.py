"""What needs no other node is checked in C++, case by case: see probes/src."""

from __future__ import annotations

import re

import pytest

from tests.underlay.rclcpp.room import PROBES, Room


def cases(program: str) -> list[str]:
    """The names of the cases in a program."""
    return re.findall(r'^    \{"(\w+)", ', (PROBES / "src" / f"{program}.cpp").read_text(), re.MULTILINE)


PROGRAMS = (
    "units", "executors", "further", "local", "wait_sets", "adapters", "small", "sources", "lifecycle",
    "actions",
)  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize(
    ("program", "case"), [(program, case) for program in PROGRAMS for case in cases(program)]
)
def test_unit(program: str, case: str, room: Room) -> None:
    ended = room.run(program, case)
    assert ended.code == 0, ended.text

"""What is checked in C++, case by case: see probes/src."""

from __future__ import annotations

import re

import pytest

from tests.underlay.message_filters.conftest import PROBES
from tests.underlay.rclcpp.room import Room

CASES = re.findall(r'^    \{"(\w+)", ', (PROBES / "src/filters.cpp").read_text(), re.MULTILINE)


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_case(case: str, room: Room) -> None:
    ended = room.run("filters", case)
    assert ended.code == 0, ended.text

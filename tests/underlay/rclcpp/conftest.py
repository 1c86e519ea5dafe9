"""The programs that use our rclcpp, compiled once, in a ROS domain that nobody else is in."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.underlay.rclcpp.room import PROBES, Room, built, open_room


@pytest.fixture(scope="session")
def prefixes(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Where rclcpp and the programs are installed."""
    return built(tmp_path_factory.mktemp("rclcpp"), PROBES, "rclcpp_probes")


@pytest.fixture
def room(prefixes: list[Path], tmp_path: Path) -> Iterator[Room]:
    """Starts programs that hear each other and nobody else."""
    with open_room(prefixes, tmp_path, "rclcpp_probes") as opened:
        yield opened

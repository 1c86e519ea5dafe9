"""The programs that use our pluginlib, and libraries with plugins, compiled once."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.underlay.rclcpp.room import Room, built, open_room

PROBES = Path(__file__).with_name("probes")


@pytest.fixture(scope="session")
def prefixes(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Where pluginlib and the programs are installed."""
    return built(tmp_path_factory.mktemp("pluginlib"), PROBES, "pluginlib_probes")


@pytest.fixture
def room(prefixes: list[Path], tmp_path: Path) -> Iterator[Room]:
    """Starts the programs."""
    with open_room(prefixes, tmp_path, "pluginlib_probes") as opened:
        yield opened

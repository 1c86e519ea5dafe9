"""A program that uses our message_filters, compiled once, in a ROS domain that nobody else is in."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.underlay.rclcpp.room import Room, built, open_room

PROBES = Path(__file__).with_name("probes")


@pytest.fixture(scope="session")
def prefixes(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Where message_filters and the program are installed."""
    return built(tmp_path_factory.mktemp("message_filters"), PROBES, "message_filters_probes")


@pytest.fixture
def room(prefixes: list[Path], tmp_path: Path) -> Iterator[Room]:
    """Starts the program."""
    with open_room(prefixes, tmp_path, "message_filters_probes") as opened:
        yield opened

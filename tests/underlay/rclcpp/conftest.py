"""The programs that use our rclcpp, compiled once, in a ROS domain that nobody else is in."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from course.isolation.levels import isolated
from course.rosenv import find_ros, node_environment
from tests.underlay.rclcpp.room import PROBES, Room, built


@pytest.fixture(scope="session")
def prefixes(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Where rclcpp and the programs are installed."""
    return built(tmp_path_factory.mktemp("rclcpp"), PROBES, "rclcpp_probes")


@pytest.fixture
def room(prefixes: list[Path], tmp_path: Path) -> Iterator[Room]:
    """Starts programs that hear each other and nobody else."""
    with isolated(namespaces=False) as place:
        no_daemon = {"ROS2COURSE_ARENA": "1"}  # it would outlive the test
        environment = {**node_environment(find_ros(), prefixes), **place.environment, **no_daemon}
        yield Room(environment, tmp_path, prefixes[0] / "lib" / "rclcpp_probes")

"""The programs that use our rclcpp, compiled once, in a ROS domain that nobody else is in."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from course.build.builder import build
from course.build.store import Store
from course.build.underlay_build import provide
from course.build.workspace import Workspace
from course.isolation.levels import isolated
from course.rosenv import find_ros, node_environment, prepare
from tests.underlay.rclcpp.room import PROBES, TIME_LIMIT, Room


@pytest.fixture(scope="session")
def prefixes(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Where rclcpp and the programs are installed. What was built of the same sources before is not again."""
    root = tmp_path_factory.mktemp("rclcpp")
    (root / "src").mkdir()
    (root / "src" / PROBES.name).symlink_to(PROBES)
    ros = find_ros()
    prepare(ros)
    workspace = Workspace.scan(root, trusted=True)
    provide(workspace, ["rclcpp_probes"], ros)
    outcome = build(workspace, ["rclcpp_probes"], ros, Store(), time_limit=TIME_LIMIT)
    assert outcome.failure is None, outcome.failure
    return [package.prefix for package in reversed(outcome.packages)]


@pytest.fixture
def room(prefixes: list[Path], tmp_path: Path) -> Iterator[Room]:
    """Starts programs that hear each other and nobody else."""
    with isolated(namespaces=False) as place:
        no_daemon = {"ROS2COURSE_ARENA": "1"}  # it would outlive the test
        environment = {**node_environment(find_ros(), prefixes), **place.environment, **no_daemon}
        yield Room(environment, tmp_path, prefixes[0] / "lib" / "rclcpp_probes")

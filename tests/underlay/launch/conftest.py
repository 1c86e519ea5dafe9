"""`launcher`: ros2 launch, with a workspace, a home and a folder for launch files."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from course.rosenv import find_ros, node_environment

pytest.register_assert_rewrite("tests.underlay.launch.cases_read")

from tests.underlay.launch.machine import Launcher  # noqa: E402
from tests.underlay.launch.workspace import make_workspace, prefixes  # noqa: E402


@pytest.fixture(scope="session")
def launch_workspace(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return make_workspace(tmp_path_factory.mktemp("workspace"))


@pytest.fixture
def launcher(launch_workspace: Path, tmp_path: Path, guarded_home: Path) -> Launcher:
    ros = find_ros()
    environment = node_environment(ros, prefixes(launch_workspace))
    environment["HOME"] = str(guarded_home)
    environment["TMPDIR"] = str(tmp_path / "tmp")
    (tmp_path / "tmp").mkdir()
    (tmp_path / "cwd").mkdir()
    environment["PATH"] = environment.get("PATH", os.defpath)
    return Launcher(ros.python, environment, tmp_path / "cwd", launch_workspace)

"""`launcher`: ros2 launch, with a workspace, a home and a folder for launch files."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from course.rosenv import find_ros, node_environment
from tests.underlay.launch.machine import SOURCES, Launcher
from tests.underlay.launch.workspace import make_workspace, prefixes


@pytest.fixture(scope="session")
def launch_workspace(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return make_workspace(tmp_path_factory.mktemp("workspace"))


@pytest.fixture
def launcher(launch_workspace: Path, tmp_path: Path, guarded_home: Path) -> Launcher:
    ros = find_ros()
    environment = node_environment(ros, prefixes(launch_workspace))
    packages = [str(SOURCES / name) for name in ("launch", "launch_ros", "ros2cli")]
    environment["PYTHONPATH"] = ":".join([*packages, environment.get("PYTHONPATH", "")])
    environment["HOME"] = str(guarded_home)
    environment["TMPDIR"] = str(tmp_path / "tmp")
    (tmp_path / "tmp").mkdir()
    (tmp_path / "cwd").mkdir()
    environment["PATH"] = environment.get("PATH", os.defpath)
    return Launcher(ros.python, environment, tmp_path / "cwd", launch_workspace)

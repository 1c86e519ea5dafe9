"""The package as an import of the tests: what it computes is checked without ROS, too."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from tests.underlay.cli.place import SOURCES
from tests.underlay.cli.workspace import built_workspace


@pytest.fixture(autouse=True)
def _ros2cli_is_importable(monkeypatch: pytest.MonkeyPatch) -> None:
    for package in ("rosidl_runtime_py", "ros2cli"):
        monkeypatch.syspath_prepend(str(SOURCES / package))
    assert str(SOURCES / "ros2cli") in sys.path


@pytest.fixture(scope="session")
def workspace(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The tutorial's packages, built once."""
    return built_workspace(tmp_path_factory)

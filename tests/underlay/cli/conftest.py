"""The package as an import of the tests: what it computes is checked without ROS, too."""

from __future__ import annotations

import sys

import pytest

from tests.underlay.cli.place import SOURCES


@pytest.fixture(autouse=True)
def _ros2cli_is_importable(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(SOURCES / "ros2cli"))
    assert str(SOURCES / "ros2cli") in sys.path

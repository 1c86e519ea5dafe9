"""Cases of failed builds, made up from what the tools print."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from course.build import Workspace
from course.build.digest import Case
from tests.build.conftest import WORKSPACE


@pytest.fixture
def case(home: Path, tmp_path: Path) -> Callable[..., Case]:
    """The case of a package whose build printed `log`, and whose setup.py, run alone, prints `said`."""
    made_up_ros(tmp_path / "ros")

    def make(name: str, log: str, said: Sequence[str] = ()) -> Case:
        workspace = Workspace.scan(home / WORKSPACE)
        package = workspace.find(name)
        assert package is not None
        lines = tuple(log.splitlines())
        prefixes = (tmp_path / "ros",)
        return Case(
            package, workspace, package.folder, lines, tmp_path / "log", prefixes, lambda: tuple(said)
        )

    return make


def made_up_ros(prefix: Path) -> None:
    index = prefix / "share/ament_index/resource_index/packages"
    index.mkdir(parents=True)
    for package in ("geometry_msgs", "std_msgs"):
        (index / package).touch()
        (prefix / "share" / package / "msg").mkdir(parents=True)
    (prefix / "share/geometry_msgs/msg/Point.msg").touch()

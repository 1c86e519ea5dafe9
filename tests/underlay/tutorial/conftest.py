"""`at_home`: a room in a new course home; `room`: one in the home of a learner who has come to chapter 22."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.shared import made_once
from tests.underlay.tutorial.learner import work_up_to_chapter_22
from tests.underlay.tutorial.room import COURSE, Room, open_room


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if item.path.is_relative_to(Path(__file__).parent):
            item.add_marker(pytest.mark.slow)


@pytest.fixture
def at_home(tmp_path: Path, guarded_home: Path) -> Iterator[Room]:
    with open_room(_make_home(tmp_path / "ros2course"), guarded_home) as room:
        yield room
        room.leave()


@pytest.fixture(scope="session")
def built_underlay() -> None:
    """Nothing has to be built before a command begins: that takes up to two minutes on a new machine."""
    subprocess.run([*COURSE, "build-underlay"], stdout=subprocess.DEVNULL, check=True)


@pytest.fixture(scope="session")
def advanced_home(built_underlay: None, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """All packages are built, and .bashrc sources them. Shared by all workers: nothing may change it."""
    return made_once(tmp_path_factory, "tutorial", _make_advanced_home) / "ros2course"


@pytest.fixture
def room(advanced_home: Path, guarded_home: Path) -> Iterator[Room]:
    with open_room(advanced_home, guarded_home) as room:
        yield room
        room.leave()


def _make_advanced_home(folder: Path) -> None:
    home, real_home = folder / "ros2course", folder / "real-home"
    real_home.mkdir(parents=True)
    with open_room(_make_home(home), real_home) as room:
        work_up_to_chapter_22(room.terminal(), home)
        room.leave()


def _make_home(home: Path) -> Path:
    subprocess.run([*COURSE, "init", str(home)], stdout=subprocess.DEVNULL, check=True)
    return home

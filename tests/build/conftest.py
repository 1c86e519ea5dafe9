"""A course home with two small packages to break, and the ROS to build them with."""

from __future__ import annotations

import contextlib
import shutil
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from course.build import BuildOutcome, Interrupt, Store, Workspace, build, package_build
from course.build.colcon import colcon_command
from course.rosenv import Ros, find_ros, prepare

HOME = Path(__file__).parent / "home"
WORKSPACE = "ros2_tutorial_workspace"
SRC = f"{WORKSPACE}/src"

# Installs what ROS looks for, and counts its runs: a stand-in where colcon itself is not what is tested.
QUICK_BUILD = """
import pathlib, sys
name, source, install, runs = sys.argv[1:5]
with open(runs, "a") as file:
    file.write(name + "\\n")
exec(pathlib.Path(source, "quick.py").read_text() if pathlib.Path(source, "quick.py").exists() else "")
marker = pathlib.Path(install, name, "share/ament_index/resource_index/packages", name)
marker.parent.mkdir(parents=True)
marker.touch()
"""


@contextlib.contextmanager
def called_off(condition: Callable[[], object]) -> Iterator[Interrupt]:
    """An event that another thread sets as soon as the condition is true."""

    def call_off() -> None:
        while not condition():
            time.sleep(0.01)
        interrupt.set()

    with Interrupt() as interrupt:
        thread = threading.Thread(target=call_off, daemon=True)
        thread.start()
        yield interrupt
        thread.join()


@pytest.fixture(scope="session")
def ros() -> Ros:
    found = find_ros()
    prepare(found)
    return found


@pytest.fixture
def home(tmp_path: Path) -> Path:
    """A separate course home, with the packages small_interfaces and small_node."""
    return shutil.copytree(HOME, tmp_path / "home")


@pytest.fixture
def src(home: Path) -> Path:
    return home / SRC


@pytest.fixture
def store(tmp_path: Path) -> Store:
    return Store(tmp_path / "store")


@pytest.fixture
def runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[], list[str]]:
    """Replaces colcon by something quick; when called, it returns the packages that were built, in order."""
    file = tmp_path / "runs"

    def quick(package: object, entry: object, *_: object) -> list[str]:
        arguments = (package.name, entry.src, entry.install, file)  # type: ignore[attr-defined]
        return [sys.executable, "-S", "-c", QUICK_BUILD, *map(str, arguments)]

    monkeypatch.setattr(package_build, colcon_command.__name__, quick)
    # Tests watch what these write beside the package.
    monkeypatch.setattr(package_build, "isolated_build", lambda *_: contextlib.nullcontext())
    return lambda: file.read_text().split() if file.exists() else []


@pytest.fixture
def built(home: Path, ros: Ros, store: Store) -> Callable[..., BuildOutcome]:
    """Builds packages of the course home as it is now."""
    return lambda *names, **options: build(Workspace.scan(home / WORKSPACE), names, ros, store, **options)

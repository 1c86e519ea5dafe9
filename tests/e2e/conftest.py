"""The real command on the real course, as a learner sees it."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pexpect
import pytest

from course.build import Store

REPO = Path(__file__).parents[2]
SOLUTIONS = REPO / "solutions"
COMMAND = [sys.executable, "-m", "course"]


@pytest.fixture(scope="session")
def builds(shared_builds: Store) -> Path:
    return shared_builds.root.parent


@pytest.fixture
def environment(guarded_home: Path, builds: Path, monkeypatch: pytest.MonkeyPatch) -> dict[str, str]:
    """The environment of a command: its own home, the shared builds, 80 columns."""
    scratch = guarded_home / "scratch"
    scratch.mkdir()
    monkeypatch.delenv("ROS2COURSE_HOME")
    return {
        **os.environ,
        "ROS2COURSE_CACHE": str(builds),
        "TMPDIR": str(scratch),
        "COLUMNS": "80",
        "PYTHONPATH": str(REPO),
        "_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1",
    }


@pytest.fixture
def course_home(guarded_home: Path) -> Path:
    return guarded_home / "ros2course"


Run = Callable[..., subprocess.CompletedProcess[str]]


@pytest.fixture
def run(environment: dict[str, str], guarded_home: Path) -> Run:
    """Run a command to its end; the result has its code and output."""

    def call(*words: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [*COMMAND, *words],
            env=environment,
            cwd=guarded_home,
            text=True,
            capture_output=True,
            timeout=300,
            check=False,
        )

    return call


STYLING = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]")
Type = Callable[..., str]


@pytest.fixture
def terminal(environment: dict[str, str], guarded_home: Path) -> Iterator[Type]:
    """Type a command at an 80-column terminal; returns all it showed. `code`: what it must end with."""

    def run(*words: str, code: int = 0) -> str:
        child = pexpect.spawn(
            COMMAND[0],
            [*COMMAND[1:], *words],
            env={**environment, "TERM": "xterm-256color"},
            cwd=str(guarded_home),
            dimensions=(24, 80),
            encoding="utf-8",
            timeout=300,
        )
        shown = STYLING.sub("", str(child.read()))
        child.close()
        assert child.exitstatus == code, shown
        return shown

    yield run


def lay(chapter: str, home: Path) -> None:
    """Copy a chapter's reference solution over what is in the home."""
    tree = SOLUTIONS / chapter / "ros2_tutorial_workspace"
    shutil.copytree(tree, home / "ros2_tutorial_workspace", dirs_exist_ok=True)

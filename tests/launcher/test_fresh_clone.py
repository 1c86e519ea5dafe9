"""The commands in the README work as written, in a fresh copy of the tree, with nothing set up.

These tests install from the package index, so they need a network.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.launcher.machine import REPO

# Read before the guard of the home folder sets HOME: what pip has downloaded already serves here too.
PIP_CACHE = os.environ.get("PIP_CACHE_DIR") or str(
    Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "pip"
)
# Variables of the one who runs the tests that would lead a command out of its clone.
FOREIGN = ("VIRTUAL_ENV", "PYTHON", "XDG_", "ROS2COURSE_", "_ROS_WHEELS_", "PYTEST_", "COV_")
LIMIT = 900.0  # seconds for one command on a slow machine with a slow network


@pytest.mark.slow
def test_the_two_commands(clone: Path) -> None:
    opens, tests = (block.strip() for block in readme()[:2])
    assert (opens, tests) == ("./ros2course next", "./run-tests")
    first = shell(clone, opens)
    assert "setting up" in first.stderr and "ready" in first.stderr
    assert first.stdout.strip()
    assert (clone.parent / "home/ros2course").is_dir()
    again = shell(clone, opens)
    assert "setting up" not in again.stderr
    # Running every test here would run this one too, and so on: it is enough that all of them are found.
    found = shell(clone, f'{tests} -m "not slow" --collect-only -q')
    assert "test_layers.py" in found.stdout
    assert shell(clone, "./ros2course list").stderr == ""
    opened = shell(clone, f"{readme()[2].strip()} -c 'pwd && ros2 pkg list'").stdout.splitlines()
    assert opened[0] == str(clone.parent / "home/ros2course")
    assert {"rclpy", "ros2cli", "launch_ros", "example_interfaces"} <= set(opened)


@pytest.mark.slow
def test_without_the_launcher(clone: Path) -> None:
    commands = next(block for block in readme() if "pip install" in block)
    assert "pip install '.[jazzy]'" in commands
    shell(clone, f"{sys.executable} -m venv venv")  # the README's python3, whatever is first on the PATH
    shell(clone, "\n".join(line for line in commands.splitlines() if "-m venv" not in line))
    # The installation is independent: the clone may be removed.
    for name in ("course", "chapters", "graders", "solutions", "underlay"):
        shutil.rmtree(clone / name)
    listed = shell(clone, "cd / && $OLDPWD/venv/bin/ros2course list").stdout
    chapters = [folder.name for folder in (REPO / "chapters").iterdir() if folder.is_dir()]
    assert chapters
    for name in chapters:
        assert name.split("-")[0] in listed
    package = next(clone.glob("venv/lib/python3.*/site-packages/course/_course"))
    for folder in ("chapters", "graders", "solutions", "underlay/src"):
        assert names(package / folder) == names(REPO / folder)
    told = shell(clone, "cd / && $OLDPWD/venv/bin/ros2course shell -c 'ros2 pkg prefix ros2cli'").stdout
    assert told.strip() == f"{clone}/venv/share/ros2course/underlay"


@pytest.fixture
def clone(tmp_path: Path) -> Path:
    """The files that git has or would take, and nothing else."""
    listing = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=REPO, check=True, capture_output=True, text=True,
    ).stdout  # fmt: skip
    folder = tmp_path / "ros2course"
    for name in filter(None, listing.split("\0")):
        if (REPO / name).exists():  # else deleted and not yet committed
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(REPO / name, folder / name)
    return folder


def readme() -> list[str]:
    """The README's blocks of commands."""
    return re.findall(r"^```sh\n(.*?)^```", (REPO / "README.md").read_text(), re.MULTILINE | re.DOTALL)


def shell(folder: Path, command: str) -> subprocess.CompletedProcess[str]:
    """Run it like a person with an empty home and no active environment."""
    own = str(Path(sys.prefix) / "bin")
    path = ":".join(part for part in os.environ["PATH"].split(":") if part != own)
    home = folder.parent / "home"
    home.mkdir(exist_ok=True)
    environ = {name: value for name, value in os.environ.items() if not name.startswith(FOREIGN)}
    # Python compiles what the commands import. To compile everything costs pip a third of its time.
    environ |= {"HOME": str(home), "PATH": path, "PIP_CACHE_DIR": PIP_CACHE, "PIP_COMPILE": "0"}
    result = subprocess.run(
        ["sh", "-ec", command], cwd=folder, env=environ, text=True, timeout=LIMIT,
        stdin=subprocess.DEVNULL, capture_output=True, check=False,
    )  # fmt: skip
    assert result.returncode == 0, f"{command}\n{result.stdout}\n{result.stderr}"
    return result


def names(folder: Path) -> list[str]:
    files = (file for file in folder.rglob("*") if file.is_file() and "__pycache__" not in file.parts)
    return sorted(str(file.relative_to(folder)) for file in files)

"""The machine for the launcher's tests.

Its PATH holds nothing but the tools linked here, so these tests also say what the launcher needs.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import signal
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.launcher.machine import REPO, Machine

TOOLS = ("cat", "cksum", "cp", "grep", "mkdir", "mv", "readlink", "rm", "sed", "sh", "tail", "touch")


@pytest.fixture
def machine(tmp_path: Path) -> Iterator[Machine]:
    """Linux on x86-64 with a Python 3.11, no ROS, and a clone in a folder with a space in its name."""
    machine = Machine(tmp_path / "my clone", tmp_path / "bin", tmp_path / "fake", tmp_path / "opt/ros/jazzy")
    for folder in (machine.clone, machine.bin, machine.fake / "answers"):
        folder.mkdir(parents=True)
    for tool in TOOLS:
        (machine.bin / tool).symlink_to(shutil.which(tool) or pytest.fail(f"no {tool} here"))
    text = (REPO / "ros2course").read_text()
    elsewhere = {"/opt/ros/jazzy": machine.opt_ros, "/usr/bin/python3": machine.bin / "system-python3"}
    for ours, theirs in elsewhere.items():
        assert f"={ours}\n" in text
        text = text.replace(f"={ours}\n", f"={theirs}\n")
    (machine.clone / "ros2course").write_text(text)
    (machine.clone / "ros2course").chmod(0o755)
    (machine.clone / "pyproject.toml").write_text("[project]\n")
    machine.python("python3")
    machine.uname()
    yield machine
    for process in machine.running:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.communicate()

"""Builds a workspace of a trial home as its learner would: where it lies, and with nothing kept."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

from course.errors import MissingHere, OurFault
from course.rosenv import find_ros, node_environment

_TIME = 120.0


def build_in_place(workspace: Path, options: Sequence[str] = ()) -> None:
    """`colcon build` with these options, anew. Raises OurFault with what it says if it fails."""
    (workspace / "src").mkdir(parents=True, exist_ok=True)  # empty folders are in no solution
    for name in ("build", "install", "log"):
        shutil.rmtree(workspace / name, ignore_errors=True)
    environment = {**node_environment(find_ros()), "HOME": str(workspace.parent)}
    command = shutil.which("colcon", path=environment["PATH"])
    if command is None:
        raise MissingHere("The program colcon is missing.", "Install it: `sudo apt install ros-dev-tools`.")
    done = subprocess.run(
        [command, "build", *options],
        cwd=workspace,
        env=environment,
        capture_output=True,
        text=True,
        timeout=_TIME,
        check=False,
    )
    if done.returncode != 0:
        raise OurFault(f"the workspace of a solution does not build: {done.stdout}{done.stderr}"[-2000:])

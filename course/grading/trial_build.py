"""Builds what is in a trial home as a learner would: in place, but always from scratch."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

from course.errors import MissingHere, OurFault
from course.files import wipe
from course.rosenv import find_ros, node_environment, plain_environment
from course.rosenv.host import require

_TIME = 120.0
_PREFIX = "-DCMAKE_INSTALL_PREFIX="


def build_in_place(folder: Path, options: Sequence[str] = ()) -> None:
    """Run `colcon build` with these options in a workspace; build and install a CMake project.

    Raises OurFault with the tool's output if it fails.
    """
    if (folder / "CMakeLists.txt").is_file():
        _install(folder, options)
        return
    (folder / "src").mkdir(parents=True, exist_ok=True)  # solutions contain no empty folders
    for name in ("build", "install", "log"):
        wipe(folder / name)
    environment = {**node_environment(find_ros()), "HOME": str(folder.parent)}
    command = shutil.which("colcon", path=environment["PATH"])
    if command is None:
        raise MissingHere("The program colcon is missing.", "Install it: `sudo apt install ros-dev-tools`.")
    _run([command, "build", *options], folder, environment)


def _install(project: Path, options: Sequence[str]) -> None:
    environment = plain_environment(find_ros())
    require(("cmake", "make", "g++"), environment["PATH"], f"Building {project.name}")
    prefixes = (option.removeprefix(_PREFIX) for option in options if option.startswith(_PREFIX))
    for folder in (project / "build", *map(Path, prefixes)):
        wipe(folder)
    _run(["cmake", "-S", ".", "-B", "build", *options], project, environment)
    _run(["cmake", "--build", "build"], project, environment)
    _run(["cmake", "--install", "build"], project, environment)


def _run(command: Sequence[str], folder: Path, environment: Mapping[str, str]) -> None:
    done = subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, timeout=_TIME, check=False
    )
    if done.returncode != 0:
        raise OurFault(f"{folder.name} of a solution does not build: {done.stdout}{done.stderr}"[-2000:])

"""One run of colcon for one package: its command line and its environment."""

from __future__ import annotations

import importlib.util
import os
import shutil
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from course.build.store import Entry
from course.build.workspace import Package
from course.errors import MissingHere
from course.rosenv import Ros, node_environment

# The log shall hold what the tools say, once, and nothing about itself.
_EVENT_HANDLERS = (
    "console_direct+",
    *(f"{name}-" for name in ("console_start_end", "console_stderr", "summary", "status", "parallel_status")),
    *(f"{name}-" for name in ("terminal_title", "desktop_notification")),
)

# What each kind of package is built with, beyond Python, and the Debian package that brings it.
_TOOLS = {"cmake": "cmake", "make": "make", "cc": "gcc", "c++": "g++"}


def colcon_command(package: Package, entry: Entry, ros: Ros, env: Mapping[str, str]) -> list[str]:
    """Build the copy in `entry.src` into `entry.install`, isolated. No symlinks: the copy may go away."""
    return [
        *_colcon(ros, env),
        *("--log-base", os.devnull, "build"),
        *("--paths", str(entry.src), "--build-base", str(entry.build), "--install-base", str(entry.install)),
        *("--executor", "sequential", "--event-handlers", *_EVENT_HANDLERS),
        *(("--cmake-args", *_cmake_arguments(ros)) if uses_cmake(package) else ()),
    ]


def build_environment(ros: Ros, entry: Entry, overlays: Sequence[Path]) -> dict[str, str]:
    """Only ROS and `overlays`; messages in English, and nothing of the user's settings for tools.

    HOME and TMPDIR lie in the entry's build folder, which goes away with the build.
    """
    temporary = entry.build / "tmp"
    temporary.mkdir(exist_ok=True)
    env = node_environment(ros, overlays)
    env = {name: value for name, value in env.items() if not name.startswith(("LC_", "LANG"))}
    return {
        **env,
        "LC_ALL": "C.UTF-8",
        "HOME": str(temporary),
        "TMPDIR": str(temporary),
        "COLCON_HOME": str(temporary),
        "PYTHONUNBUFFERED": "1",  # so that lines of several programs stand in their order
    }


def uses_cmake(package: Package) -> bool:
    return package.build_type != "ament_python"


def require_tools(package: Package, env: Mapping[str, str]) -> None:
    """Raise MissingHere when this machine lacks a tool that the package's build type needs."""
    if not uses_cmake(package):
        return
    missing = [name for name in _TOOLS if shutil.which(name, path=env.get("PATH", os.defpath)) is None]
    if missing:
        what = f"Building {package.name} needs {_joined(missing)}, which this machine lacks."
        raise MissingHere(what, f"sudo apt install {' '.join(_TOOLS[name] for name in missing)}")


def _cmake_arguments(ros: Ros) -> tuple[str, ...]:
    # Tests are not what is graded, and the linters that templates ask for may not be installed.
    return ("-DBUILD_TESTING=OFF", f"-DPython3_EXECUTABLE={ros.python}", "--no-warn-unused-cli")


def _colcon(ros: Ros, env: Mapping[str, str]) -> list[str]:
    if ros.origin == "pip":
        return [str(ros.python), "-m", "colcon"]
    if found := shutil.which("colcon", path=env.get("PATH", os.defpath)):
        return [found]
    if importlib.util.find_spec("colcon"):
        return [sys.executable, "-m", "colcon"]
    raise MissingHere(
        "Building packages needs colcon, which this machine lacks.",
        "sudo apt install python3-colcon-common-extensions",
    )


def _joined(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"

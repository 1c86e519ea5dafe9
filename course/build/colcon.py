"""One run of colcon for one package: its command line, its environment, and what this machine lacked for it.

A build that failed because this machine lacks something is never the learner's failure. A build can print
anything, so what its log says about the machine is verified.
"""

from __future__ import annotations

import contextlib
import importlib.util
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from course.build.store import StoreEntry, disk_full
from course.build.workspace import Package
from course.errors import CourseError, MissingHere
from course.rosenv import Ros, node_environment
from course.rosenv.host import SYSTEM, lacks_library, missing_library, require

# The log must contain what the tools print, once, and nothing else.
_EVENT_HANDLERS = (
    "console_direct+",
    *(f"{name}-" for name in ("console_start_end", "console_stderr", "summary", "status", "parallel_status")),
    *(f"{name}-" for name in ("terminal_title", "desktop_notification")),
)

# What packages in C++ are built with.
_TOOLS = ("cmake", "make", "cc", "c++")
_FULL = re.compile(r"No space left on device|Disk quota exceeded")
_MEMORY = re.compile(r"Killed signal terminated program|Cannot allocate memory|out of memory allocating")
_PYTHON_HEADERS = re.compile(
    r"Could NOT find Python3.*missing:.*(Development|Include|INCLUDE)|Python\.h: No such file"
)
_NO_COMPILER = re.compile(r"No CMAKE_C(XX)?_COMPILER could be found")
_NO_LIBRARY = re.compile(r"^\s+(?P<name>Eigen3|Qt5\w*)Config\.cmake$")
# What C++ is compiled with to find the line where a program crashes.
SANITIZED = "-g1 -fsanitize=address -fno-omit-frame-pointer"
_ROOM = 64 * 1024 * 1024
_SECONDS = 30.0


def colcon_command(package: Package, entry: StoreEntry, ros: Ros, env: Mapping[str, str]) -> list[str]:
    """Builds the copy in `entry.src` into `entry.install`, isolated. No symlinks: the copy may be removed."""
    return [
        *_colcon(ros, env),
        *("--log-base", os.devnull, "build"),
        *("--paths", str(entry.src), "--build-base", str(entry.build), "--install-base", str(entry.install)),
        *("--executor", "sequential", "--event-handlers", *_EVENT_HANDLERS),
        *(("--cmake-args", *_cmake_arguments(ros)) if uses_cmake(package) else ()),
    ]


def build_environment(ros: Ros, entry: StoreEntry, overlays: Sequence[Path]) -> dict[str, str]:
    """Only ROS and `overlays`; messages in English, and none of the user's settings for tools.

    HOME and TMPDIR are in the entry's build folder, which is removed after the build.
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
        "CMAKE_INSTALL_ALWAYS": "1",  # when a build resumes, times in seconds tell CMake too little
        "PYTHONUNBUFFERED": "1",  # keeps lines of several programs in order
    }


def uses_cmake(package: Package) -> bool:
    return package.build_type != "ament_python"


def require_tools(package: Package, env: Mapping[str, str]) -> None:
    """Raise MissingHere if this machine lacks a tool that the package's build type needs."""
    if uses_cmake(package):
        require(_TOOLS, env.get("PATH", os.defpath), f"Building {package.name}")


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


def _kills() -> int | None:
    """How many programs the kernel has killed for lack of memory; None if unknown."""
    with contextlib.suppress(OSError, ValueError):
        for line in Path("/proc/vmstat").read_text(encoding="ascii").splitlines():
            if line.startswith("oom_kill "):
                return int(line.split()[1])
    return None


@dataclass(frozen=True)
class Killed:
    """Created before a build; knows afterwards whether the kernel killed anything for lack of memory."""

    before: int | None = field(default_factory=_kills)

    def any(self) -> bool:
        return self.before is None or _kills() != self.before


@dataclass(frozen=True)
class Machine:
    """Where builds are kept, and the Python that they use. was_full: whether the disk was full meanwhile."""

    store: Path
    python: Path
    killed: Killed
    system: tuple[Path, ...] = SYSTEM
    was_full: bool = False

    def is_full(self) -> bool:
        return self.was_full or shutil.disk_usage(self.store).free < _ROOM

    def lacks_headers(self) -> bool:
        where = "import sysconfig; print(sysconfig.get_path('include'))"
        found = _output([str(self.python), "-I", "-c", where])
        return not Path(found.strip(), "Python.h").exists()

    def lacks_compiler(self) -> bool:
        return not all(_output([name, "--version"]) for name in ("cc", "c++"))


def raise_if_machine(lines: Sequence[str], machine: Machine) -> None:
    """Raise StorageError or MissingHere if the log says that this machine is at fault, and it is."""
    for line in lines:
        fault = _fault(line, machine)
        if fault is not None:
            raise fault


def _fault(line: str, machine: Machine) -> CourseError | None:
    if _FULL.search(line) and machine.is_full():
        return disk_full(machine.store)
    if _MEMORY.search(line) and machine.killed.any():
        return MissingHere(
            "This machine ran out of memory while building.", "Close some programs, then try again."
        )
    if _PYTHON_HEADERS.search(line) and machine.lacks_headers():
        what = (
            f"Building interfaces needs the header files of {machine.python.name}, which this machine lacks."
        )
        return MissingHere(what, "sudo apt install python3-dev")
    if _NO_COMPILER.search(line) and machine.lacks_compiler():
        return MissingHere("This machine has no working C++ compiler.", "sudo apt install g++")
    if (found := _NO_LIBRARY.search(line)) and lacks_library(found["name"], machine.system):
        return missing_library(found["name"])
    return None


def _output(command: Sequence[str]) -> str:
    with contextlib.suppress(OSError, subprocess.TimeoutExpired):
        return subprocess.run(command, capture_output=True, text=True, timeout=_SECONDS, check=False).stdout
    return ""

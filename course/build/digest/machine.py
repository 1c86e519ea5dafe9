"""Builds that failed for want of something on this machine: never the learner's failure.

A log says what the build likes, so that what it says of the machine must be true of it, too.
"""

from __future__ import annotations

import contextlib
import re
import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from course.build.store import disk_full
from course.errors import CourseError, MissingHere
from course.rosenv.libraries import SYSTEM, lacks_library, missing_library

_FULL = re.compile(r"No space left on device|Disk quota exceeded")
_MEMORY = re.compile(r"Killed signal terminated program|Cannot allocate memory|out of memory allocating")
_PYTHON_HEADERS = re.compile(
    r"Could NOT find Python3.*missing:.*(Development|Include|INCLUDE)|Python\.h: No such file"
)
_NO_COMPILER = re.compile(r"No CMAKE_C(XX)?_COMPILER could be found")
_NO_LIBRARY = re.compile(r"^\s+(?P<name>Eigen3|Qt5\w*)Config\.cmake$")

_ROOM = 64 * 1024 * 1024
_SECONDS = 30.0


def _kills() -> int | None:
    """How many programs the kernel has killed for want of memory so far; None if it does not say."""
    with contextlib.suppress(OSError, ValueError):
        for line in Path("/proc/vmstat").read_text(encoding="ascii").splitlines():
            if line.startswith("oom_kill "):
                return int(line.split()[1])
    return None


@dataclass(frozen=True)
class Killed:
    """Made before a build: tells afterwards whether the kernel has killed anything for want of memory."""

    before: int | None = field(default_factory=_kills)

    def any(self) -> bool:
        return self.before is None or _kills() != self.before


@dataclass(frozen=True)
class Machine:
    """Where builds are kept, and the Python that they use."""

    store: Path
    python: Path
    killed: Killed
    system: tuple[Path, ...] = SYSTEM

    def is_full(self) -> bool:
        return shutil.disk_usage(self.store).free < _ROOM

    def lacks_headers(self) -> bool:
        where = "import sysconfig; print(sysconfig.get_path('include'))"
        found = _output([str(self.python), "-I", "-c", where])
        return not Path(found.strip(), "Python.h").exists()

    def lacks_compiler(self) -> bool:
        return not all(_output([name, "--version"]) for name in ("cc", "c++"))


def raise_if_machine(lines: Sequence[str], machine: Machine) -> None:
    """Raise StorageError or MissingHere when the log says that this machine is at fault, and it is."""
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
        return MissingHere("This machine has no C++ compiler that works.", "sudo apt install g++")
    if (found := _NO_LIBRARY.search(line)) and lacks_library(found["name"], machine.system):
        return missing_library(found["name"])
    return None


def _output(command: Sequence[str]) -> str:
    with contextlib.suppress(OSError, subprocess.TimeoutExpired):
        return subprocess.run(command, capture_output=True, text=True, timeout=_SECONDS, check=False).stdout
    return ""

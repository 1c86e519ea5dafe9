"""Builds that failed for want of something on this machine: never the learner's failure."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from course.build.store import disk_full
from course.errors import MissingHere

_FULL = re.compile(r"No space left on device|Disk quota exceeded")
_MEMORY = re.compile(r"Killed signal terminated program|Cannot allocate memory|out of memory allocating")
_PYTHON_HEADERS = re.compile(
    r"Could NOT find Python3.*missing:.*(Development|Include|INCLUDE)|Python\.h: No such file"
)
_NO_COMPILER = re.compile(r"No CMAKE_C(XX)?_COMPILER could be found")


def raise_if_machine(lines: Sequence[str], place: Path, python: Path) -> None:
    """Raise StorageError or MissingHere when the log says that this machine is at fault."""
    for line in lines:
        if _FULL.search(line):
            raise disk_full(place)
        if _MEMORY.search(line):
            raise MissingHere(
                "This machine ran out of memory while building.", "Close some programs, then try again."
            )
        if _PYTHON_HEADERS.search(line):
            what = f"Building interfaces needs the header files of {python.name}, which this machine lacks."
            raise MissingHere(what, "sudo apt install python3-dev")
        if _NO_COMPILER.search(line):
            raise MissingHere("This machine has no C++ compiler that works.", "sudo apt install g++")

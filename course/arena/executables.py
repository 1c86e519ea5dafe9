"""From a package and an executable's name to the command that starts it."""

from __future__ import annotations

import os
import re
from pathlib import Path

_PYTHON = re.compile(r"python[\d.]*")
# What installers write when a first line with the interpreter's path would be too long, or hold spaces.
_LONG_PATH = re.compile(rb"#!/bin/sh\n'''exec' [^\n]*python[\d.]*\"? ")


def installed_executables(prefix: Path, package: str) -> tuple[str, ...]:
    """Names that `ros2 run PACKAGE` finds in this install prefix: executable files of lib/PACKAGE."""
    folder = prefix / "lib" / package
    if not folder.is_dir():
        return ()
    return tuple(sorted(f.name for f in folder.iterdir() if f.is_file() and os.access(f, os.X_OK)))


def command_for(prefix: Path, package: str, executable: str, python: str) -> tuple[str, ...]:
    """How to start an installed executable.

    A Python script is started with `python`, the interpreter that knows this ROS, whatever
    its first line says: the system's own Python knows nothing of ROS wheels.
    """
    file = prefix / "lib" / package / executable
    return (python, str(file)) if _is_python_script(file) else (str(file),)


def _is_python_script(file: Path) -> bool:
    with file.open("rb") as stream:
        head = stream.read(4096)
    if _LONG_PATH.match(head):
        return True
    if not head.startswith(b"#!"):
        return False
    words = head[2:].partition(b"\n")[0].decode("utf-8", errors="replace").split()
    return any(_PYTHON.fullmatch(Path(word.strip("\"'")).name) for word in words)

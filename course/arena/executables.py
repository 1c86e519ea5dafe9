"""From a package and an executable's name to the command that starts it."""

from __future__ import annotations

import os
from pathlib import Path

_PYTHON = ("python", "python3")


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
        first = stream.readline(512)
    if not first.startswith(b"#!"):
        return False
    words = first[2:].decode("utf-8", errors="replace").split()
    return any(Path(word).name.rstrip("0123456789.").startswith(_PYTHON) for word in words[:2])

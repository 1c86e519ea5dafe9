"""The command line of an executable: prefix, and the Python that knows this ROS."""

from __future__ import annotations

import os
import shlex
import shutil
import sys
from collections.abc import Sequence
from pathlib import Path


def command_line(executable: str, arguments: Sequence[str], prefix: str | None = None) -> list[str]:
    """Return what is to be started."""
    return [*shlex.split(prefix or ""), *interpreted(executable), *arguments]


def interpreted(executable: str) -> list[str]:
    """Return the command for an executable: a script of another Python gets the one that runs this.

    ROS from pip is known to one Python only, while colcon may have been run by another one, whose path then
    stands in the script's first line.
    """
    words = _shebang(executable)
    if not words or not _is_python(words[0]) or _is_this_python(words[0]):
        return [executable]
    print(f"[ros2run]: started with {sys.executable}, as {words[0]} does not know this ROS", file=sys.stderr)
    return [sys.executable, *words[1:], executable]


def _shebang(executable: str) -> list[str]:
    """Return the interpreter of a script and its options; `env` is looked through."""
    try:
        with Path(executable).open("rb") as file:
            line = file.readline(512)
    except OSError:
        return []
    words = line[2:].decode(errors="replace").split() if line.startswith(b"#!") else []
    return _without_env(words) if words and Path(words[0]).name == "env" else words


def _without_env(words: list[str]) -> list[str]:
    rest = [word for word in words[1:] if word != "-S"]
    return [shutil.which(rest[0]) or rest[0], *rest[1:]] if rest else []


def _is_python(interpreter: str) -> bool:
    name = Path(interpreter).name
    return name.startswith("python") and not name.removeprefix("python").strip("0123456789.")


def _is_this_python(interpreter: str) -> bool:
    """Tell whether it is the same program of the same environment (python, python3 and python3.12)."""
    this = Path(sys.executable)
    same_folder = os.path.realpath(this.parent) == os.path.realpath(Path(interpreter).parent)
    return same_folder and os.path.realpath(this) == os.path.realpath(interpreter)

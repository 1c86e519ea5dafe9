"""The Python that a script of a package is started with, where its own does not know this ROS.

ROS from pip is known to one Python only; colcon may have been run by another one, whose path is then in
the first line of what it installed. `ros2 run` asks here, too.
"""

from __future__ import annotations

import os
import re
import shutil
import sys
from dataclasses import dataclass
from pathlib import Path

_PYTHON = re.compile(r"python[\d.]*")


@dataclass(frozen=True)
class Interpreter:
    """`command` is to be put before the program, and `told` says why; both are empty if nothing is to be."""

    command: tuple[str, ...] = ()
    told: str = ""


def interpreter_for(program: str) -> Interpreter:
    """This Python, with the options of the program's first line, if that names one without this ROS."""
    words = _first_line(program)
    if not words or not _PYTHON.fullmatch(Path(words[0]).name) or _is_ours(words[0]):
        return Interpreter()
    return Interpreter(
        (sys.executable, *words[1:]), f"started with {sys.executable}, as {words[0]} does not know this ROS"
    )


def _first_line(program: str) -> list[str]:
    """The words after `#!`; those of `env` are followed."""
    try:
        with Path(program).open("rb") as file:
            line = file.readline(512)
    except OSError:
        return []
    words = line[2:].decode("utf-8", "replace").split() if line.startswith(b"#!") else []
    if not words or Path(words[0]).name != "env":
        return words
    rest = [word for word in words[1:] if word != "-S"]
    return [shutil.which(rest[0]) or rest[0], *rest[1:]] if rest else []


def _is_ours(interpreter: str) -> bool:
    """The same program in the same environment, whatever it is called there."""
    theirs, ours = Path(interpreter), Path(sys.executable)
    together = os.path.realpath(theirs.parent) == os.path.realpath(ours.parent)
    return together and os.path.realpath(theirs) == os.path.realpath(ours)

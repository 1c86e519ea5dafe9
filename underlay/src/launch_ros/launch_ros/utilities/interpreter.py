"""The Python that a script of a package is started with, where its own does not know this ROS.

ROS from pip is known to one Python only; colcon may have been run by another one, whose path then stands in
the first line of what it installed.
"""

from __future__ import annotations

import os
import re
import shutil
import sys
from pathlib import Path

_PYTHON = re.compile(r"python[\d.]*")


def interpreter_for(program: str) -> list[str]:
    """What is to be put before the program: nothing, or this Python with the options of its first line."""
    words = _first_line(program)
    if not words or not _PYTHON.fullmatch(Path(words[0]).name) or _is_ours(words[0]):
        return []
    return [sys.executable, *words[1:]]


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

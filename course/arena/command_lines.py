"""Command lines for ROS programs, with their `--ros-args`, and for the linter of Python files."""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Iterable, Mapping
from math import isinf, isnan
from pathlib import Path, PurePosixPath

_PYTHON = re.compile(r"python[\d.]*")
# What installers write if the interpreter's path is too long for the first line, or contains spaces.
_LONG_PATH = re.compile(rb"#!/bin/sh\n'''exec' [^\n]*python[\d.]*\"? ")
Scalar = bool | int | float | str
ParameterValue = Scalar | list[bool] | list[int] | list[float] | list[str]
LINT_TIME = 10.0
# With these, the learner's settings and comments cannot silence a rule.
_OPTIONS = ("--isolated", "--no-cache", "--ignore-noqa", "--output-format", "concise")
# Runs alongside the learner's programs, confined as they are.
_RENAMED = """
import json, os, subprocess, sys
names = json.loads(sys.argv[1])
for old, new in names.items():
    os.rename(old, new)
code = subprocess.call(sys.argv[2:])
for old, new in names.items():
    os.rename(new, old)
sys.exit(code)
"""


def installed_executables(prefix: Path, package: str) -> tuple[str, ...]:
    """Names that `ros2 run PACKAGE` finds in this install prefix: the executable files in lib/PACKAGE."""
    folder = prefix / "lib" / package
    if not folder.is_dir():
        return ()
    return tuple(sorted(f.name for f in folder.iterdir() if f.is_file() and os.access(f, os.X_OK)))


def command_for(prefix: Path, package: str, executable: str, python: str) -> tuple[str, ...]:
    """How to start an installed executable.

    A Python script is started with `python`, the interpreter that has this ROS, whatever its first line
    says, because the system's own Python has no ROS wheels.
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


def ros_args(
    params: Mapping[str, ParameterValue] | None = None,
    remaps: Mapping[str, str] | None = None,
    node_name: str | None = None,
) -> tuple[str, ...]:
    """`--ros-args -p name:=value -r from:=to -r __node:=name`; empty if nothing is given."""
    given = [("-p", f"{name}:={parameter_text(value)}") for name, value in (params or {}).items()]
    given += [("-r", f"{old}:={new}") for old, new in (remaps or {}).items()]
    given += [("-r", f"__node:={node_name}")] if node_name else []
    return ("--ros-args", *(word for pair in given for word in pair)) if given else ()


def parameter_text(value: ParameterValue) -> str:
    """A value in the YAML that rcl reads. A string stays a string, whatever it looks like."""
    if isinstance(value, list):
        return f"[{', '.join(map(_scalar, value))}]"
    return _scalar(value)


def _scalar(value: Scalar) -> str:
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)  # a string in double quotes means the same in YAML
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float) and (isnan(value) or isinf(value)):
        return ".nan" if isnan(value) else "-.inf" if value < 0 else ".inf"
    return repr(value)


def lint_command(folder: str, rules: tuple[str, ...], renamed: Mapping[str, str]) -> tuple[str, ...]:
    """Return the command that applies these rules of ruff. renamed: temporary names, by the files' own."""
    python = (sys.executable, "-I")
    ruff = (*python, "-m", "ruff", "check", *_OPTIONS, "--select", ",".join(rules), folder)
    return (*python, "-c", _RENAMED, json.dumps(renamed), *ruff)


def public_names(files: Iterable[str]) -> dict[str, str]:
    """`words.py` for `_words.py`, unless that exists already.

    A linter treats everything in `_words.py` as private, so it asks for no docstrings or type hints there.
    But the package exports these names.
    """
    every, found = set(files), dict[str, str]()
    for file in sorted(every):
        path = PurePosixPath(file)
        public = str(path.with_name(path.name.lstrip("_")))
        private = path.name.startswith("_") and not path.name.startswith("__")
        if private and path.suffix == ".py" and public not in every:
            found[file] = public
            every.add(public)
    return found

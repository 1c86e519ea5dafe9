"""Substitutions written in a text: `$(var name)`, `$(env HOME)`, `$(find-pkg-share package)` and so on."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable
from typing import Any

from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.substitutions import (
    AnonName,
    Command,
    EnvironmentVariable,
    FindExecutable,
    LaunchConfiguration,
    PythonExpression,
    ThisLaunchFile,
    ThisLaunchFileDir,
)
from launch.substitutions.substitution_failure import SubstitutionFailure

from launch_ros.substitutions import ExecutableInPackage, FindPackagePrefix, FindPackageShare

_INNERMOST = re.compile(r"\$\(([\w-]+)((?:\s+[^()$]*)?)\)")
_KNOWN: dict[str, Callable[..., Substitution]] = {
    "anon": AnonName,
    "command": Command,
    "dirname": ThisLaunchFileDir,
    "env": lambda name, *default: EnvironmentVariable(name, default_value=default[0] if default else None),
    "eval": lambda *words: PythonExpression(" ".join(words)),
    "exec-in-pkg": lambda executable, package: ExecutableInPackage(executable=executable, package=package),
    "filename": ThisLaunchFile,
    "find-exec": lambda name: FindExecutable(name=name),
    "find-pkg-prefix": FindPackagePrefix,
    "find-pkg-share": FindPackageShare,
    "optenv": lambda name, default="": EnvironmentVariable(name, default_value=default),
    "var": lambda name, *default: LaunchConfiguration(name, default=default[0] if default else None),
}


def replaced(context: LaunchContext, text: str) -> str:
    """The text with all of them performed, the inner ones first."""

    def perform(match: re.Match[str]) -> str:
        return _substitution(match[1], match[2].strip()).perform(context)

    while True:
        after = _INNERMOST.sub(perform, text)
        if after == text:
            return text
        text = after


def _substitution(kind: str, arguments: str) -> Any:
    if kind not in _KNOWN:
        raise SubstitutionFailure(f"unknown substitution '$({kind} ...)' in a parameter file")
    try:
        # An expression keeps its quotes: they are Python's.
        words = [arguments] if kind == "eval" else shlex.split(arguments)
        return _KNOWN[kind](*words)
    except TypeError as error:
        raise SubstitutionFailure(f"wrong arguments of '$({kind} {arguments})'") from error

"""The command line of an executable: prefix, and the Python that knows this ROS."""

from __future__ import annotations

import shlex
import sys
from collections.abc import Sequence

from launch_ros.utilities.interpreter import interpreter_for


def command_line(executable: str, arguments: Sequence[str], prefix: str | None = None) -> list[str]:
    """Return what is to be started."""
    interpreter = interpreter_for(executable)
    if interpreter.told:
        print(f"[ros2run]: {interpreter.told}", file=sys.stderr)
    return [*shlex.split(prefix or ""), *interpreter.command, executable, *arguments]

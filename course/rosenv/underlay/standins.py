"""Texts of the small programs that the prefix holds: scripts, and what stands in for a package not yet built.

A stand-in builds its package when it is first asked for, and then makes way for the real thing. In an arena
nothing is built: there the course has seen to it beforehand.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

_ROOT = Path(__file__).parents[3]


@dataclass(frozen=True)
class Builder:
    """How a stand-in calls the course: `python` runs it, `cache` is the folder for what it can make again."""

    python: Path
    cache: Path

    def words(self, package: str) -> list[str]:
        """The command that builds `package`, in any folder and whatever else is on PYTHONPATH."""
        code = f"import sys; sys.path.insert(0, {str(_ROOT)!r}); from course.cli.main import run; run()"
        return [str(self.python), "-I", "-c", code, "build-underlay", package]

    @property
    def variables(self) -> dict[str, str]:
        """What the command needs in its environment: a build may have given it another HOME."""
        return {"ROS2COURSE_CACHE": str(self.cache), "_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1"}


def script(python: Path, module: str, function: str) -> str:
    """A console script. Its first lines are for the shell: a path may be too long there, or hold spaces.

    Ctrl+C while it loads ends it without a traceback; from then on it is the function's own matter.
    """
    return f"""\
#!/bin/sh
'''exec' "{python}" "$0" "$@"
' '''
import signal
import sys

_hears_ctrl_c = signal.getsignal(signal.SIGINT) is signal.default_int_handler
if _hears_ctrl_c:
    signal.signal(signal.SIGINT, signal.SIG_DFL)

from {module} import {function}

if _hears_ctrl_c:
    signal.signal(signal.SIGINT, signal.default_int_handler)

if __name__ == "__main__":
    sys.exit({function}())
"""


def cmake(package: str, own: Path, real: Path, builder: Builder) -> str:
    """A <package>Config.cmake for the folder `own`: has the package built, goes on with the one in `real`.

    Until then `real` is a link to `own`.
    """
    set_variables = [f"{name}={value}" for name, value in builder.variables.items()]
    command = _cmake_words(["-E", "env", *set_variables, *builder.words(package)])
    return f"""\
# {package} is built when it is first needed; after that this file is not found any more.
get_filename_component(_ros2course_here [==[{own}]==] REALPATH)
get_filename_component(_ros2course_found [==[{real}]==] REALPATH)
if(_ros2course_found STREQUAL _ros2course_here)
  message(STATUS "Building {package}, this once")
  execute_process(COMMAND ${{CMAKE_COMMAND}} {command} RESULT_VARIABLE _ros2course_failed)
  if(_ros2course_failed)
    message(FATAL_ERROR "{package} could not be built; the reason stands above.")
  endif()
endif()
set({package}_DIR [==[{real}]==])
include([==[{real}/{package}Config.cmake]==])
"""


def python(package: str, real: Path, builder: Builder) -> str:
    """A Python package that has the one in `real` built, and becomes it."""
    return f'''\
"""{package} is built when it is first imported; after that this file is not found any more."""

import os
import pathlib
import subprocess
import sys

_here, _real = pathlib.Path(__file__).resolve(), pathlib.Path({str(real)!r}, "__init__.py")
if _real.resolve() == _here:
    if os.environ.get("ROS2COURSE_ARENA"):
        raise ImportError("{package} was not built before it was needed")
    _environment = {{**os.environ, **{builder.variables!r}}}
    if subprocess.run({builder.words(package)!r}, env=_environment, stdout=sys.stderr).returncode:
        raise ImportError("{package} could not be built; the reason stands above")
__path__, __file__ = [str(_real.parent)], str(_real)
exec(compile(_real.read_bytes(), __file__, "exec"))
'''


def _cmake_words(words: Sequence[str]) -> str:
    return " ".join(f"[==[{word}]==]" for word in words)

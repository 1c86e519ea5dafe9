"""The two small files that a learner's shell needs; they lie in the course home's own folder.

.ros2course/shell/start.bash       what bash reads first: ROS 2, the learner's .bashrc, the prompt
.ros2course/shell/bin/ros2course   this very program, so that its name alone works in every folder
"""

from __future__ import annotations

import os
import shlex
import sys
from pathlib import Path

from course.cli.words import CALLED_AS, LAUNCHER, PROGRAM
from course.home import CourseHome
from course.home.storage import storing
from course.rosenv.files import write_atomic

# The learner's own .bashrc comes after ROS 2 and before the prompt: what they set there is meant.
# Completion is loaded at the first Tab: 124 tells bash to look again.
_START = """\
# Written by `ros2course shell` each time: edit ~/.bashrc instead.
. {setup}
if [ -r ~/.bashrc ]; then . ~/.bashrc; fi
case ":$PATH:" in *:{folder}:*) ;; *) PATH={folder}:$PATH ;; esac
PS1='(ros2course) \\w\\$ '
_ros2course_first_tab() {{
    eval "$(_ROS2COURSE_COMPLETE=source_bash ros2course)" && return 124
}}
complete -F _ros2course_first_tab ros2course
"""
_COMMAND = """\
#!/bin/sh
# Written by `ros2course shell`.
export {called_as}=ros2course _ROS_WHEELS_BOOTSTRAP_COMPLETE=1
exec {command} "$@"
"""


def write_start_file(home: CourseHome, setup: Path) -> Path:
    """Write what bash starts with, for the ROS 2 that `setup` sources; returns the file."""
    folder = write_command(home)
    start = folder.with_name("start.bash")
    text = _START.format(setup=shlex.quote(str(setup)), folder=shlex.quote(str(folder)))
    with storing(f"{start} cannot be written"):
        write_atomic(start, text)
    return start


def write_command(home: CourseHome) -> Path:
    """Write the program that calls this one from anywhere; returns the folder for PATH."""
    file = home.state / "shell" / "bin" / PROGRAM
    with storing(f"{file} cannot be written"):
        write_atomic(file, _COMMAND.format(called_as=CALLED_AS, command=own_command(file)))
        file.chmod(0o755)
    return file.parent


def own_command(not_this: Path) -> str:
    """The words that run this program from any folder: the launcher, the installed script, or Python."""
    for candidate in (os.environ.get(LAUNCHER), sys.argv[0]):
        file = Path(candidate or "").absolute()
        if file.name == PROGRAM and file != not_this and os.access(file, os.X_OK) and file.is_file():
            return shlex.quote(str(file))
    root = Path(__file__).parents[2]
    code = f"import sys; sys.path[0] = {str(root)!r}; from course.cli.main import run; run()"
    return f"{shlex.quote(sys.executable)} -c {shlex.quote(code)}"

"""`shell` and `env`: the learner's shell, in the course home and with ROS 2 ready."""

from __future__ import annotations

import os
import shlex
import shutil
import sys
from pathlib import Path
from typing import Annotated

import typer

from course.cli.options import options_of
from course.cli.session import home_of
from course.cli.usage import CALLED_AS, LAUNCHER, PROGRAM, examples, typed
from course.errors import MissingHere
from course.files import write_atomic
from course.home import CourseHome
from course.home.storage import storing
from course.rosenv import cache_dir, find_ros, prepare, setup_script
from course.rosenv.paths import split, without

# The learner's .bashrc comes after ROS 2 and before our prompt, so their settings count.
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
    """Write bash's start file, for the ROS 2 that `setup` sources; returns its path."""
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
    """The command that runs this program from any folder: the launcher, the installed script, or Python."""
    for candidate in (os.environ.get(LAUNCHER), sys.argv[0]):
        file = Path(candidate or "").absolute()
        if file.name == PROGRAM and file != not_this and os.access(file, os.X_OK) and file.is_file():
            return shlex.quote(str(file))
    root = Path(__file__).parents[2]
    code = f"import sys; sys.path[0] = {str(root)!r}; from course.cli.main import run; run()"
    return f"{shlex.quote(sys.executable)} -c {shlex.quote(code)}"


EXAMPLES = examples(
    ("shell", "until you type exit"),
    ("shell -c 'ros2 topic list'", "run one command there"),
)
ENV_EXAMPLES = (
    "\b\nExamples:\n"
    f'  eval "$({PROGRAM} env)"      set up this shell\n'
    f"  {PROGRAM} env >> ~/.bashrc   set up every new one"
)


def shell(
    ctx: typer.Context,
    command: Annotated[
        str | None,
        typer.Option("--command", "-c", metavar="COMMAND", help="Run this command instead of a shell."),
    ] = None,
) -> None:
    """Open bash in your course home, with ROS 2 ready.

    In it, ~ is your course home, so you can type every path in the lessons
    exactly as written. Your own home is not touched. The exit code is bash's.
    """
    bash = shutil.which("bash")
    if bash is None:
        raise MissingHere("The program bash is missing.", "Install it: `sudo apt install bash`.")
    home = home_of(options_of(ctx))
    start = str(write_start_file(home, _setup_script()))
    words = ["--rcfile", start, "-i"] if command is None else ["-c", f". {shlex.quote(start)}\n{command}"]
    os.chdir(home.path)
    sys.stdout.flush()
    # Replaces this process, so that job control, signals and the exit code are bash's own.
    os.execve(bash, ["bash", *words], _environment(home))


def env(ctx: typer.Context) -> None:
    """Print the lines that set up your own shell for the course.

    The lines set up ROS 2, say where your course home is, and let you type
    ros2course in any folder.
    """
    home = home_of(options_of(ctx))
    lines = (
        setup_line(),
        f"export ROS2COURSE_HOME={shlex.quote(str(home.path))}",
        f"export PATH={shlex.quote(str(write_command(home)))}:$PATH",
        f'# For the shell you are in:  eval "$({typed("env")})"',
        f"# For every new one:         {typed('env')} >> ~/.bashrc",
    )
    typer.echo("\n".join(lines))


def setup_line() -> str:
    """What makes ROS 2 ready in bash, for a terminal or for ~/.bashrc. Raises MissingHere without a ROS 2."""
    return f"source {shlex.quote(str(_setup_script()))}"


def _setup_script() -> Path:
    ros = find_ros()
    prepare(ros)
    return setup_script(ros)


def _environment(home: CourseHome) -> dict[str, str]:
    dropped = (LAUNCHER, CALLED_AS, "PROMPT_COMMAND")
    environment = {name: value for name, value in _without_own_libraries().items() if name not in dropped}
    # With another HOME, the cache and the course home would be looked for in other places.
    return {
        **environment,
        "HOME": str(home.path),
        "ROS2COURSE_HOME": str(home.path),
        "ROS2COURSE_CACHE": str(cache_dir(os.environ)),
    }


def _without_own_libraries() -> dict[str, str]:
    """The environment without what Python with ROS wheels adds to it when this process starts.

    It lists libraries in an order that varies, so two shells would differ; setup.bash has them in order.
    """
    name, prefix = "LD_LIBRARY_PATH", sys.prefix
    environment = dict(os.environ)
    if name in environment and prefix not in split(environment.get("AMENT_PREFIX_PATH")):
        paths = without(split(environment.pop(name)), (Path(prefix),))
        environment |= {name: ":".join(paths)} if paths else {}
    return environment

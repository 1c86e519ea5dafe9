"""`shell` and `env`: the learner's shell, in the course home and with ROS 2 ready."""

from __future__ import annotations

import os
import shlex
import shutil
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.words import CALLED_AS, LAUNCHER, PROGRAM, examples, typed

if TYPE_CHECKING:
    from course.home import CourseHome

EXAMPLES = examples(
    ("shell", "until you type exit"),
    ("shell -c 'ros2 topic list'", "run one command there"),
)
ENV_EXAMPLES = (
    "\b\nExamples:\n"
    f'  eval "$({PROGRAM} env)"      make this shell ready\n'
    f"  {PROGRAM} env >> ~/.bashrc   make every new one ready"
)


def shell(
    ctx: typer.Context,
    command: Annotated[
        str | None,
        typer.Option("--command", "-c", metavar="COMMAND", help="Run this instead of asking for commands."),
    ] = None,
) -> None:
    """Open bash in your course home, with ROS 2 ready.

    In it, ~ is your course home, so every path in the lessons can be typed as it
    stands; your own home is not touched. Ends with bash's exit code.
    """
    from course.cli.desk import home_of
    from course.cli.options import options_of
    from course.cli.shell_files import write_start_file
    from course.errors import MissingHere

    bash = shutil.which("bash")
    if bash is None:
        raise MissingHere("The program bash is missing.", "Install it: `sudo apt install bash`.")
    home = home_of(options_of(ctx))
    start = str(write_start_file(home, _setup_script()))
    words = ["--rcfile", start, "-i"] if command is None else ["-c", f". {shlex.quote(start)}\n{command}"]
    os.chdir(home.path)
    sys.stdout.flush()
    # Not a child: job control, signals and the exit code are bash's own.
    os.execve(bash, ["bash", *words], _environment(home))


def env(ctx: typer.Context) -> None:
    """Print what makes a shell of your own ready for the course.

    The lines set ROS 2 up, say where your course home is, and let you type
    ros2course in any folder.
    """
    from course.cli.desk import home_of
    from course.cli.options import options_of
    from course.cli.shell_files import write_command

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
    from course.rosenv import find_ros, prepare, setup_script

    ros = find_ros()
    prepare(ros)
    return setup_script(ros)


def _environment(home: CourseHome) -> dict[str, str]:
    from course.rosenv import cache_dir

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
    """The environment without what the start-up of Python with ROS wheels puts into it for this process.

    It lists libraries in an order that varies, so two shells would differ; setup.bash has them in order.
    """
    from course.rosenv.overlays import split, without

    name, prefix = "LD_LIBRARY_PATH", sys.prefix
    environment = dict(os.environ)
    if name in environment and prefix not in split(environment.get("AMENT_PREFIX_PATH")):
        paths = without(split(environment.pop(name)), (Path(prefix),))
        environment |= {name: ":".join(paths)} if paths else {}
    return environment

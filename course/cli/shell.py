"""`shell` and `env`: the learner's shell, in the course home and with ROS 2 ready."""

from __future__ import annotations

import os
import shlex
import shutil
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from course.cli.words import LAUNCHER, PROGRAM, examples

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
    from course.errors import MissingHere

    bash = shutil.which("bash")
    if bash is None:
        raise MissingHere("The program bash is missing.", "Install it: `sudo apt install bash`.")
    home = home_of(options_of(ctx))
    script = _start_script(home)
    words = ["-c", f". {shlex.quote(str(script))}\n{command}"] if command else ["--rcfile", str(script), "-i"]
    os.chdir(home.path)
    sys.stdout.flush()
    # Not a child: job control, signals and the exit code are bash's own.
    os.execve(bash, ["bash", *words], _environment(home))


def env(ctx: typer.Context) -> None:
    """Print what makes a shell of your own ready for the course.

    The lines set ROS 2 up and tell ros2course where your course home is.
    """
    from course.cli.desk import home_of
    from course.cli.options import options_of

    home = home_of(options_of(ctx))
    lines = (
        f"export ROS2COURSE_HOME={shlex.quote(str(home.path))}",
        f"source {shlex.quote(str(_setup_script()))}",
        '# For this shell:       eval "$(' + _own_command() + ' env)"',
        "# For every new shell:  add the two lines above to ~/.bashrc",
    )
    typer.echo("\n".join(lines))


def _setup_script() -> Path:
    from course.rosenv import find_ros, prepare, setup_script

    ros = find_ros()
    prepare(ros)
    return setup_script(ros)


def _start_script(home: CourseHome) -> Path:
    """Write the file that bash starts with. It stays in the course home's own folder for such things."""
    from course.errors import StorageError
    from course.rosenv.files import write_atomic

    script = home.state / "shell.bash"
    try:
        write_atomic(script, _START.format(setup=shlex.quote(str(_setup_script())), command=_own_command()))
    except OSError as error:
        raise StorageError(
            f"{script} cannot be written: {error.strerror}.", f"See to {script.parent}."
        ) from error
    return script


# The learner's own .bashrc comes last but for the prompt: what they set there is meant.
_START = """\
# Written by `ros2course shell` each time; edit ~/.bashrc instead.
. {setup}
[ -r ~/.bashrc ] && . ~/.bashrc
ros2course() {{ {launcher}=ros2course {command} "$@"; }}
export -f ros2course
PS1='(ros2course) \\w\\$ '
""".replace("{launcher}", LAUNCHER)


def _environment(home: CourseHome) -> dict[str, str]:
    from course.rosenv.paths import cache_dir

    environment = {
        name: value for name, value in os.environ.items() if name not in (LAUNCHER, "PROMPT_COMMAND")
    }
    # With another HOME, the cache and the course home would be looked for in other places.
    return {
        **environment,
        "HOME": str(home.path),
        "ROS2COURSE_HOME": str(home.path),
        "ROS2COURSE_CACHE": str(cache_dir(os.environ)),
    }


def _own_command() -> str:
    """The words that run this program from any folder."""
    for candidate in (os.environ.get(LAUNCHER), sys.argv[0]):
        file = Path(candidate or "").absolute()
        if file.name == PROGRAM and os.access(file, os.X_OK) and file.is_file():
            return shlex.quote(str(file))
    root = Path(__file__).parents[2]
    code = f"import sys; sys.path[0] = {str(root)!r}; from course.cli.main import run; run()"
    return f"{shlex.quote(sys.executable)} -c {shlex.quote(code)}"

"""The words of the command line: the program's name, examples for help, and where options may be."""

from __future__ import annotations

import os
import re
import shlex
import sys
from collections.abc import Sequence

PROGRAM = "ros2course"
# Set by the launcher to what was typed (`./ros2course`), so that advice can be typed in turn.
LAUNCHER = "ROS2COURSE_LAUNCHER"
# Set by the command in the learner's shell, which calls the launcher under this shorter name.
CALLED_AS = "ROS2COURSE_CALLED_AS"
GLOBAL_OPTIONS = ("--home", "--course")


def program() -> str:
    """How this command was called: `ros2course`, or `./ros2course` from a fresh clone."""
    return os.environ.get(CALLED_AS) or os.environ.get(LAUNCHER) or PROGRAM


def spoken(text: str) -> str:
    """The text, with each `ros2course ...` written as it can be typed here."""
    here = program()
    return text if here == PROGRAM else re.sub(rf"(?<![\w./-]){PROGRAM}(?= [a-z-])", lambda _: here, text)


def typed(words: str) -> str:
    """One of our commands as it can be typed here."""
    return f"{program()} {words}"


def installing(extra: str) -> str:
    """The command that installs an optional tool's packages, in the way this course was installed."""
    launcher = os.environ.get(LAUNCHER)
    if launcher:
        return f"{launcher} --setup-only {extra}"
    # By their names: the course itself is in no package index.
    from importlib.metadata import requires  # slow to import, and seldom needed

    wanted = (one.partition(";") for one in requires(PROGRAM) or ())
    packages = [name.strip() for name, _, when in wanted if f'"{extra}"' in when.replace("'", '"')]
    return shlex.join([sys.executable, "-m", "pip", "install", *packages])


def examples(*pairs: tuple[str, str]) -> str:
    """The examples under a command's help: (what to type after the program's name, what it is for)."""
    width = max(len(words) for words, _ in pairs)
    lines = (f"  {PROGRAM} {words.ljust(width)}  {why}".rstrip() for words, why in pairs)
    return "\b\nExamples:\n" + "\n".join(lines)


def global_options_first(words: Sequence[str]) -> list[str]:
    """`--home DIR` and `--course DIR` may also follow the command; this moves them before it.

    Words after `--` stay, and so does an option without its value, for the parser to complain about.
    """
    end = words.index("--") if "--" in words else len(words)
    first: list[str] = []
    rest: list[str] = []
    queue = list(words[:end])
    while queue:
        word = queue.pop(0)
        if word in GLOBAL_OPTIONS and queue:
            first += [word, queue.pop(0)]
        elif word.startswith(tuple(f"{option}=" for option in GLOBAL_OPTIONS)):
            first.append(word)
        else:
            rest.append(word)
    return first + rest + list(words[end:])

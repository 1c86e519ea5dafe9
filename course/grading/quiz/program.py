"""The program that a question shows: the learner predicts its output, then it really runs."""

from __future__ import annotations

import re
import shutil
import tempfile
from collections.abc import Sequence
from pathlib import Path

from course.build.runner import Ending, Interrupt, run
from course.content import Choice, Question
from course.errors import OurFault
from course.isolation.isolation_plan import BUILD
from course.isolation.levels import isolated_build
from course.isolation.sandbox import hand_over
from course.rosenv import Ros, node_environment, prepare
from course.rosenv.host import require

TIME_LIMIT = 30.0
_CODE = re.compile(r"`([^`]+)`")
_ERROR = re.compile("error|exception|interrupt", re.IGNORECASE)
_TRACEBACK = re.compile(r"Traceback \(most recent call last\):\n(?:(?:[ \t].*)?\n)*")


def printed(program: Path, ros: Ros) -> tuple[str, ...]:
    """Run a script of the course in its own folder, and return its lines; of a traceback, only the last one.

    C++ is compiled first. The script has no network, and sees none of the learner's files. Raises OurFault if
    it does not end, and MissingHere if this machine has no compiler.
    """
    prepare(ros)
    with tempfile.TemporaryDirectory(prefix="ros2course-program-") as name:
        folder, output = Path(name, "home"), Path(name, "output")
        folder.mkdir()
        shutil.copy(program, folder)
        environment = {
            **node_environment(ros),
            "HOME": str(folder),
            "PYTHONUNBUFFERED": "1",  # keeps printed and logged lines in order
            "RCUTILS_COLORIZED_OUTPUT": "0",
            "RCUTILS_CONSOLE_OUTPUT_FORMAT": "[{severity}] [{name}]: {message}",
        }
        if program.suffix == ".cpp":
            require(("g++",), environment["PATH"])
        with isolated_build(ros, environment, (folder,), (), BUILD) as plan, Interrupt() as stop:
            hand_over(folder, plan.user if plan else None)
            command = (*_COMMANDS[program.suffix], program.name)
            ended = run(plan, command, folder, environment, output, TIME_LIMIT, stop)
        if ended.ending is not Ending.EXITED:
            raise OurFault(f"{program.name} did not end within {TIME_LIMIT:.0f} s")
        return tuple(_TRACEBACK.sub("", output.read_text(errors="replace")).splitlines())


_COMMANDS = {
    ".cpp": ("bash", "-c", 'g++ -std=c++17 "$0" -o program && exec ./program'),
    ".py": ("python3",),
    ".sh": ("bash",),
}


def wrong_about(question: Question, lines: Sequence[str]) -> str | None:
    """What is wrong with the choices of a question whose program prints `lines`; None if nothing is."""
    shown = " / ".join(lines) or "nothing"
    for choice in question.choices:
        if choice.right and not _says(choice, lines):
            return f"The program prints {shown}, but the right choice says: {choice.text}"
        if not choice.right and _says(choice, lines):
            return f"The program prints {shown}, and that is what a wrong choice says: {choice.text}"
    return None


def _says(choice: Choice, lines: Sequence[str]) -> bool:
    """Whether a choice has each line of the output in backquotes. For an error, its name is enough."""
    said = _CODE.findall(choice.text)
    return len(said) == len(lines) and all(
        line == word or (_ERROR.search(word) and line.startswith(f"{word}:"))
        for word, line in zip(said, lines, strict=True)
    )

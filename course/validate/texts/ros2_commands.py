"""Whether the `ros2` lines in texts are ones that the command understands."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from course.content.names import did_you_mean
from course.errors import OurFault
from course.rosenv.underlay import source_root
from course.validate.model import Finding
from course.validate.texts import ros2_program
from course.validate.texts.markdown import contents
from course.validate.texts.prose import Prose
from course.validate.texts.shell_lines import Command, Unreadable, commands
from course.validate.texts.types import Types

_PATIENCE = 60.0


def ros2_findings(course: Path, texts: Sequence[Prose]) -> Iterator[Finding]:
    """Says nothing where this installation has no `ros2` of ours to ask. course: its folder."""
    shown: list[tuple[Prose, Command]] = []
    for text in texts:
        for code in contents(text.text).codes:
            for found in commands(code, "ros2"):
                if isinstance(found, Unreadable):
                    yield unreadable(text, found)
                else:
                    shown.append((text, found))
    for (text, command), complaint in zip(shown, _complaints([one for _, one in shown]), strict=True):
        if complaint:
            what = f"`{' '.join(command.words)}` is nothing that `ros2` understands: {_short(complaint)}"
            step = "correct it; `ros2 COMMAND --help` shows what there is"
            yield Finding(text.file, text.at(command.line), what, step, text.exercise)
    yield from _of_types(course, shown)


def _of_types(course: Path, shown: Sequence[tuple[Prose, Command]]) -> Iterator[Finding]:
    types = Types(course) if shown else None
    for text, command in shown:
        complaint = types.complaint(command) if types else None
        if complaint:
            what = f"in `{' '.join(command.words)}`: {complaint}"
            step = "correct it; `ros2 interface list` shows what there is"
            yield Finding(text.file, text.at(command.line), what, step, text.exercise)


def unreadable(text: Prose, found: Unreadable) -> Finding:
    what = f"no shell can read `{found.text}`: a quotation mark is not closed"
    return Finding(text.file, text.at(found.line), what, "close it", text.exercise)


def _short(complaint: str) -> str:
    """Of all that could have been chosen, only what was probably meant."""
    match = re.match(r"invalid choice: '(.*)' \(choose from (.*)\)$", complaint)
    if match is None:
        return complaint
    known = [name.strip(" '") for name in match[2].split(",")]
    return f"there is no `{match[1]}`{did_you_mean(match[1], known)}"


def _complaints(shown: Sequence[Command]) -> list[str | None]:
    root = source_root()
    if root is None or not shown:
        return [None] * len(shown)
    lines = [(one.words[1:], one.mentioned, one.only_name) for one in shown]
    asked = list(dict.fromkeys(lines))
    environment = {**os.environ, "PYTHONPATH": str(root / "src/ros2cli")}
    done = subprocess.run(
        [sys.executable, str(Path(ros2_program.__file__))],
        input=json.dumps(asked),
        env=environment,
        capture_output=True,
        text=True,
        timeout=_PATIENCE,
        check=False,
    )
    if done.returncode != 0:
        raise OurFault(f"the parsers of `ros2` cannot be asked: {done.stderr.strip().splitlines()[-1:]}")
    found: dict[object, str | None] = dict(zip(asked, json.loads(done.stdout), strict=True))
    return [found[line] for line in lines]

"""Reads a document as steps: files that it shows, and commands to type, in order."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

# A file: its path alone on a line, then what is in it. A fence of more backticks may hold one of fewer.
_STEP = re.compile(
    r"^(?:`(?P<file>[^`\n]+)`:\n\n)?^(?P<fence>`{3,})(?P<kind>\w*)\n(?P<text>.*?)^(?P=fence)$", re.M | re.S
)
_ENDS_WITH = re.compile(r"\s+# ends with (\d+).*$")


@dataclass(frozen=True)
class File:
    """A file to write."""

    name: str
    text: str


@dataclass(frozen=True)
class Command:
    """A line to type, and the exit code that the document promises."""

    line: str
    code: int = 0


def steps(document: Path) -> list[File | Command]:
    found: list[File | Command] = []
    for step in _STEP.finditer(document.read_text(encoding="utf-8")):
        if step["file"]:
            found.append(File(step["file"], step["text"]))
        elif step["kind"] == "sh":
            found += map(_command, step["text"].splitlines())
    return found


def _command(line: str) -> Command:
    promised = _ENDS_WITH.search(line)
    return Command(_ENDS_WITH.sub("", line), int(promised[1]) if promised else 0)

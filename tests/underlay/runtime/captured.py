"""What the real command printed, read from tests/underlay/captures."""

from __future__ import annotations

import re
import shlex
from dataclasses import dataclass
from pathlib import Path

CAPTURES = Path(__file__).parents[1] / "captures"
_SECTION = re.compile(r"^# ---- (\w+) ----\n", re.MULTILINE)
_COMMAND = re.compile(r"^# command: (.*)$", re.MULTILINE)
_CODES = re.compile(r"^# exit code\(s\) over \d+ runs: \[(.*)\]", re.MULTILINE)


@dataclass(frozen=True)
class Capture:
    """One case: what was typed, and what came of it. `files` are those that were made."""

    arguments: tuple[str, ...]
    code: int
    stdout: str
    stderr: str
    files: tuple[str, ...]


def capture(name: str) -> Capture:
    """Read one case. The first word of its command, ros2, is left out."""
    head, *rest = _SECTION.split((CAPTURES / f"{name}.txt").read_text(encoding="utf-8"))
    sections = dict(zip(rest[::2], rest[1::2], strict=True))
    files = (line for line in sections.get("files", "").splitlines() if "(empty directory)" not in line)
    return Capture(
        tuple(shlex.split(_found(_COMMAND, head))[1:]),
        int(_found(_CODES, head)),
        sections["stdout"],
        sections["stderr"],
        tuple(sorted(files)),
    )


def _found(pattern: re.Pattern[str], text: str) -> str:
    match = pattern.search(text)
    assert match, f"no {pattern.pattern} in {text[:80]}"
    return match[1]

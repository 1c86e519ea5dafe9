"""What the real `ros2 launch` printed, and what is the same of it on every machine and in every run."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

CAPTURES = Path(__file__).parents[1] / "captures"
_SECTION = re.compile(r"^# ---- (\w+) ----\n", re.MULTILINE)
_VARYING = (
    (re.compile(r"\d{4}-\d\d-\d\d-\d\d-\d\d-\d\d-\d{6}-\S+-\d+"), "<log>"),
    (re.compile(r"<workspace>/install/\w+/"), "<prefix-of-a-package>/"),
    (re.compile(r"\bpid (\[)?\d+"), "pid <n>"),
    (re.compile(r"\S+/launch_params_\w+"), "<params-file>"),  # before addresses: its name may hold `0x`
    (re.compile(r"0x[0-9a-f]+"), "<address>"),
    (re.compile(r"\[\d{10}\.\d{9}\]"), "[<stamp>]"),
    (re.compile(r"searching: \[.*\]"), "searching: [...]"),
)


@dataclass(frozen=True)
class Capture:
    """One case: what was typed after `ros2 launch`, and what came of it."""

    words: tuple[str, ...]
    code: int
    stdout: str
    stderr: str


def capture(name: str) -> Capture:
    text = (CAPTURES / f"launch_{name}.txt").read_text(encoding="utf-8")
    head, *rest = _SECTION.split(text)
    sections = dict(zip(rest[::2], rest[1::2], strict=True))
    command = re.search(r"^# command: ros2 launch (.*)$", head, re.MULTILINE)
    codes = re.search(r"runs: \[(-?\d+)\]", head)
    assert command and codes
    return Capture(tuple(command[1].split()), int(codes[1]), sections["stdout"], sections["stderr"])


def normal(text: str, replaced: dict[str, str] | None = None) -> list[str]:
    """The lines, without what differs from run to run; `replaced` puts placeholders for paths."""
    for path, placeholder in (replaced or {}).items():
        text = text.replace(path, placeholder)
    for pattern, placeholder in _VARYING:
        text = pattern.sub(placeholder, text)
    return [line.rstrip("\r") for line in text.splitlines()]

"""What the real command printed, and how it was ended, read from tests/underlay/captures."""

from __future__ import annotations

import re
import shlex
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tests.underlay.runtime.command import Answer as Outcome

__all__ = ["CAPTURES", "Case", "Outcome", "Stop", "case"]

CAPTURES = Path(__file__).parents[1] / "captures"
_OTHER = re.compile(r"^# ==== other outcome: exit (\d+)", re.M)
_STOP = re.compile(r"^# stop: (SIG\w+) (?:when output matches /(.*)/|after ([\d.]+)s) \((.*?)\)", re.M)


@dataclass(frozen=True)
class Stop:
    """The signal that ended it: when its output matched `when`, or after so many seconds."""

    signal: str
    when: str | None
    after: float | None
    to_group: bool


@dataclass(frozen=True)
class Case:
    """`words` are the command line, ros2 first. On a terminal both streams are in stdout."""

    name: str
    words: tuple[str, ...]
    expected: Outcome
    stop: Stop | None
    on_terminal: bool

    @property
    def arguments(self) -> list[str]:
        return list(self.words[1:])

    def job(self) -> dict[str, Any]:
        """As the driver wants it. What goes on until it is stopped is to print as much as the real one."""
        words = [word.replace("<cwd>", str(CAPTURES)) for word in self.words]
        stop = vars(self.stop) | {"lines": self.expected.stdout.count("\n")} if self.stop else None
        return {"words": words, "stop": stop, "on_terminal": self.on_terminal}


def case(name: str) -> Case:
    """The capture as it went when the real command found what was there."""
    text = (CAPTURES / f"{name}.txt").read_text(encoding="utf-8")
    main, *_ = re.split(r"\n# ==== other outcome", text, maxsplit=1)
    head, _, streams = main.partition("# ---- stdout ----\n")
    out, _, err = streams.partition("# ---- stderr ----\n")
    out, _, _ = out.partition("# (no trailing newline)\n")
    command = _found(r"^# command: (.*)$", head)
    codes = set(_found(r"runs: \[([-\d, ]+)\]", head).split(", "))
    outcome = Outcome(int(max(codes - set(_OTHER.findall(text)) or codes)), out, err)
    return Case(name, tuple(shlex.split(command)), outcome, _stop(head), "stdout is a pty" in head)


def _stop(head: str) -> Stop | None:
    match = _STOP.search(head)
    if not match:
        return None
    signal, when, after, whom = match.groups()
    return Stop(signal, when, float(after) if after else None, "group" in whom)


def _found(pattern: str, text: str) -> str:
    match = re.search(pattern, text, re.M)
    assert match, pattern
    return match[1]

"""The pipe from the grading process to its parent: one JSON object a line."""

from __future__ import annotations

import json
import os
from dataclasses import asdict, dataclass
from typing import Any

from course.feedback import Feedback, feedback_from_dict
from course.grading.result import CheckResult, check_from_dict


@dataclass(frozen=True)
class Judgement:
    """What the grading process found. evidence: seconds that the scenario took.

    lag: seconds that the process had to wait for a CPU at worst meanwhile. cpu: seconds of it that the
    submission's programs used. judged: False where the recording was kept for somebody else to judge.
    missing: True when `fault` is something that this machine lacks, with what installs it as its advice.
    """

    checks: tuple[CheckResult, ...]
    evidence: float
    fault: Feedback | None = None
    lag: float = 0.0
    cpu: float = 0.0
    judged: bool = True
    missing: bool = False


class Channel:
    """The writing end. Messages beyond what the pipe takes at once block until they are read."""

    def __init__(self, descriptor: int) -> None:
        self._descriptor = descriptor

    def progress(self, text: str) -> None:
        self._send({"kind": "progress", "text": text})

    def judgement(self, judgement: Judgement) -> None:
        self._send({"kind": "judgement", **asdict(judgement)})

    def _send(self, data: dict[str, Any]) -> None:
        rest = (json.dumps(data) + "\n").encode()
        while rest:
            rest = rest[os.write(self._descriptor, rest) :]


def read_message(line: str) -> str | Judgement:
    """A line of the channel: a progress text, or the judgement. Raises ValueError on anything else."""
    try:
        data = json.loads(line)
        if data["kind"] == "progress":
            return str(data["text"])
        checks = tuple(check_from_dict(item) for item in data["checks"])
        fault = feedback_from_dict(data["fault"])
        rest = (data[name] for name in ("lag", "cpu", "judged", "missing"))
        return Judgement(checks, data["evidence"], fault, *rest)
    except (KeyError, TypeError) as error:
        raise ValueError(f"this is no message of the grading process: {error}") from error

"""The results of grading: plain data that travels between processes and to renderers.

The grading process writes a `Result` as JSON; the command line, the reports and the batch
read it back. Nothing here knows how it will be shown.
"""

from __future__ import annotations

import json
import re
from enum import Enum
from pathlib import Path
from typing import Any

import msgspec
from msgspec import Struct

from course.errors import DamagedData
from course.model import codec
from course.model.feedback import Feedback, Location, Pace

__all__ = [
    "CheckResult",
    "Doubt",
    "Feedback",
    "Location",
    "Outcome",
    "Result",
    "Timing",
    "Verdict",
    "from_json",
    "to_dict",
    "to_json",
    "verdict_of",
]

SCHEMA_VERSION = 1
# Control characters that JSON does not escape, marks that reverse the direction of text, and half characters.
_UNSAFE = re.compile("[\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ud800-\udfff]")


class Outcome(str, Enum):
    """How one check ended. Only FAILED is the learner's fault; ERROR is ours.

    SKIPPED: an earlier check failed. NOT_APPLICABLE: it cannot be judged here (a submission lacks what
    belongs to the learner's machine, or this machine lacks something); it does not affect the verdict.
    """

    PASSED = "passed"
    FAILED = "failed"
    SKIPPED = "skipped"
    NOT_APPLICABLE = "not applicable"
    ERROR = "error"


class Doubt(str, Enum):
    """Why another attempt may end differently.

    SPOILT: something went wrong on our side that the submission may have caused. KILLED: one of the
    submission's programs was killed: by itself, from outside, or because Ctrl+C did not end it. BUSY: the
    machine had too much else to do, which no submission can cause.
    """

    SPOILT = "spoilt"
    KILLED = "killed"
    BUSY = "busy"


class Verdict(str, Enum):
    """How a whole exercise ended."""

    PASSED = "passed"
    NOT_PASSED = "not passed"
    NOT_APPLICABLE = "not applicable"
    NOT_AVAILABLE = "not available here"
    OUR_ERROR = "our error"


class CheckResult(Struct, frozen=True):
    """One check of an exercise.

    id: unique within the exercise, stable over versions.
    points: what it is worth. earned: 0, or `share` (from 0 to 1) of the points.
    bonus: not needed to pass the exercise.
    feedback: set if failed or error; for a right answer in a quiz, its explanation.
    skipped_because: set if skipped or not applicable.
    pace: how often messages should have arrived, if the check asked for that.
    doubt: set if another attempt may end differently.
    """

    id: str
    title: str
    points: int | float
    outcome: Outcome
    bonus: bool = False
    feedback: Feedback | None = None
    skipped_because: str | None = None
    pace: Pace | None = None
    doubt: Doubt | None = None
    share: int | float = 1

    @property
    def earned(self) -> float:
        return self.points * self.share if self.outcome is Outcome.PASSED else 0.0


class Timing(Struct, frozen=True):
    """Seconds spent: `build`, `evidence` (scenario start to its end), `total` (command to verdict).

    lag: the longest time that a program had to wait for a CPU, unless the submission caused it (see
    `arena.lateness`). cpu: CPU time that the submission's programs used.
    """

    build: float = 0.0
    evidence: float = 0.0
    total: float = 0.0
    lag: float = 0.0
    cpu: float = 0.0


class Result(Struct, frozen=True):
    """The verdict on one exercise.

    fault: set only for OUR_ERROR and NOT_AVAILABLE: what is wrong on our side or missing here.
    doubt: set only if another attempt may end differently: with a fault, or for a killed program.
    containment: how the learner's processes were isolated ("namespaces" or "domain").
    notes: minor remarks for the reader (what this machine lacks, what was done instead).
    bonus: the course is complete without this exercise.
    """

    exercise: str
    verdict: Verdict
    checks: tuple[CheckResult, ...] = ()
    timing: Timing = Timing()
    fault: Feedback | None = None
    containment: str = ""
    notes: tuple[str, ...] = ()
    bonus: bool = False
    doubt: Doubt | None = None

    @property
    def points(self) -> float:
        """Points earned, bonus included."""
        return sum(check.earned for check in self.checks)

    @property
    def max_points(self) -> float:
        """Points that can be earned here without bonus checks."""
        return sum(check.points for check in self.checks if _counts(check))


def verdict_of(checks: tuple[CheckResult, ...]) -> Verdict:
    """Passed if every check that is not a bonus passed; our error if any check is one.

    Checks that are not applicable do not count. If that leaves none that are needed, the exercise is not
    applicable. An exercise without any checks is our error: nothing passes for lack of evidence.
    """
    if not checks or any(check.outcome is Outcome.ERROR for check in checks):
        return Verdict.OUR_ERROR
    needed = [check for check in checks if _counts(check)]
    if not needed and any(check.outcome is Outcome.NOT_APPLICABLE for check in checks):
        return Verdict.NOT_APPLICABLE
    passed = bool(needed) and all(check.outcome is Outcome.PASSED for check in needed)
    return Verdict.PASSED if passed else Verdict.NOT_PASSED


def _counts(check: CheckResult) -> bool:
    return not check.bonus and check.outcome is not Outcome.NOT_APPLICABLE


def not_applicable(exercise: str, because: str, *, bonus: bool = False) -> Result:
    """The result of an exercise that cannot be graded here, through nobody's fault."""
    return Result(exercise, Verdict.NOT_APPLICABLE, notes=(because,), bonus=bonus)


def to_dict(result: Result) -> dict[str, Any]:
    """The result as plain JSON types, with `schema` (integer) and the sums of points."""
    data = msgspec.to_builtins(result)
    return {"schema": SCHEMA_VERSION, **data, "points": result.points, "max_points": result.max_points}


def to_json(result: Result, *, indent: int | None = None) -> str:
    """As JSON that is valid UTF-8, and safe to show in a terminal despite what submissions print."""
    text = json.dumps(to_dict(result), indent=indent, ensure_ascii=False)
    return _UNSAFE.sub(lambda found: f"\\u{ord(found[0]):04x}", text)


def from_json(text: str, source: str | Path = "this result") -> Result:
    """Read what `to_json` wrote. Raises DamagedData, which names `source`, on anything else."""
    found = codec.from_json(text, _Schema, source)
    if found.schema != SCHEMA_VERSION:
        raise DamagedData(f"{source} is of schema {found.schema}, not {SCHEMA_VERSION}.")
    return codec.from_json(text, Result, source)


class _Schema(Struct):
    schema: int

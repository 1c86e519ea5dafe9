"""What a check ends with: plain data that travels between processes and to renderers.

The grading process writes a `Result` as JSON; the command line, the reports and the batch
read it back. Nothing here knows how it will be shown.
"""

from __future__ import annotations

import dataclasses
import json
from dataclasses import dataclass
from enum import Enum
from typing import Any

from course.feedback import Feedback, Location, feedback_from_dict

__all__ = [
    "CheckResult",
    "Feedback",
    "Location",
    "Outcome",
    "Result",
    "Timing",
    "Verdict",
    "check_from_dict",
    "from_json",
    "to_dict",
    "to_json",
    "verdict_of",
]

SCHEMA_VERSION = 1


class Outcome(str, Enum):
    """How one check ended. Only FAILED is the learner's; ERROR is ours."""

    PASSED = "passed"
    FAILED = "failed"
    SKIPPED = "skipped"
    ERROR = "error"


class Verdict(str, Enum):
    """How a whole exercise ended."""

    PASSED = "passed"
    NOT_PASSED = "not passed"
    NOT_AVAILABLE = "not available here"
    OUR_ERROR = "our error"


@dataclass(frozen=True)
class CheckResult:
    """One check of an exercise.

    id: unique within the exercise, stable over versions.
    points: what it is worth; earned: what it brought (0 or points).
    bonus: not needed to pass the exercise.
    feedback: set when failed or error. skipped_because: set when skipped.
    """

    id: str
    title: str
    points: float
    outcome: Outcome
    bonus: bool = False
    feedback: Feedback | None = None
    skipped_because: str | None = None

    @property
    def earned(self) -> float:
        return self.points if self.outcome is Outcome.PASSED else 0.0


@dataclass(frozen=True)
class Timing:
    """Seconds spent: `build`, `evidence` (scenario start to its end), `total` (command to verdict)."""

    build: float = 0.0
    evidence: float = 0.0
    total: float = 0.0


@dataclass(frozen=True)
class Result:
    """The verdict on one exercise.

    fault: set only for OUR_ERROR and NOT_AVAILABLE: what is wrong on our side or missing here.
    containment: how the learner's processes were kept apart ("namespaces" or "domain").
    notes: quiet lines for the reader (what this machine lacks, what was done instead).
    """

    exercise: str
    verdict: Verdict
    checks: tuple[CheckResult, ...] = ()
    timing: Timing = Timing()
    fault: Feedback | None = None
    containment: str = ""
    notes: tuple[str, ...] = ()

    @property
    def points(self) -> float:
        """Points earned, bonus included."""
        return sum(check.earned for check in self.checks)

    @property
    def max_points(self) -> float:
        """Points that can be had without bonus checks."""
        return sum(check.points for check in self.checks if not check.bonus)


def verdict_of(checks: tuple[CheckResult, ...]) -> Verdict:
    """Passed when every check that is not a bonus passed; our error if any check is one.

    An exercise without a single judged check is our error: nothing passes for lack of evidence.
    """
    if not checks or any(check.outcome is Outcome.ERROR for check in checks):
        return Verdict.OUR_ERROR
    needed = [check for check in checks if not check.bonus]
    passed = bool(needed) and all(check.outcome is Outcome.PASSED for check in needed)
    return Verdict.PASSED if passed else Verdict.NOT_PASSED


def to_dict(result: Result) -> dict[str, Any]:
    """The result as plain JSON types, with `schema` (integer) and the sums of points."""
    data = dataclasses.asdict(result)
    return {"schema": SCHEMA_VERSION, **data, "points": result.points, "max_points": result.max_points}


def to_json(result: Result, *, indent: int | None = None) -> str:
    return json.dumps(to_dict(result), indent=indent, ensure_ascii=False)


def from_json(text: str) -> Result:
    """Read what `to_json` wrote. Raises ValueError or KeyError on anything else."""
    data = json.loads(text)
    schema = data.get("schema") if isinstance(data, dict) else None
    if schema != SCHEMA_VERSION:
        raise ValueError(f"result schema {schema!r} is not {SCHEMA_VERSION}")
    try:
        return _from_dict(data)
    except (TypeError, AttributeError) as error:  # a list for an object, an unknown field
        raise ValueError(f"this is no result: {error}") from error


def _from_dict(data: dict[str, Any]) -> Result:
    return Result(
        exercise=data["exercise"],
        verdict=Verdict(data["verdict"]),
        checks=tuple(check_from_dict(item) for item in data["checks"]),
        timing=Timing(**data["timing"]),
        fault=feedback_from_dict(data["fault"]),
        containment=data["containment"],
        notes=tuple(data["notes"]),
    )


def check_from_dict(data: dict[str, Any]) -> CheckResult:
    return CheckResult(
        id=data["id"],
        title=data["title"],
        points=data["points"],
        outcome=Outcome(data["outcome"]),
        bonus=data["bonus"],
        feedback=feedback_from_dict(data["feedback"]),
        skipped_because=data["skipped_because"],
    )

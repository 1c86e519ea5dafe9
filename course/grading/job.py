"""What the grading process is told: plain data, as one line of JSON on its standard input."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

from course.evidence.packages import BuiltPackages, packages_from_dict


@dataclass(frozen=True)
class Job:
    """One exercise to grade.

    home: the course home whose files are read. roots: the files and folders of it that belong
    to the exercise. environment: for the learner's programs. python: their interpreter.
    evidence: where to keep the recording (MCAP), or None.
    """

    exercise: str
    grader: str
    home: str
    roots: tuple[str, ...]
    packages: BuiltPackages
    environment: Mapping[str, str]
    python: str
    evidence: str | None = None


def to_line(job: Job) -> str:
    return json.dumps(asdict(job))


def from_line(line: str) -> Job:
    """Read what `to_line` wrote."""
    data: dict[str, Any] = json.loads(line)
    packages = packages_from_dict(data.pop("packages"))
    return Job(**{**data, "roots": tuple(data["roots"])}, packages=packages)

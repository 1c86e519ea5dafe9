"""What the grading process is told: plain data, as one line of JSON on its standard input."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

from course.arena.sandbox.plan import Plan, plan_from_dict
from course.evidence.packages import BuiltPackages, packages_from_dict


@dataclass(frozen=True)
class Job:
    """One exercise to grade.

    home: the course home whose files are read. roots: the files and folders of it that belong
    to the exercise. environment: for the learner's programs. python: their interpreter.
    evidence: where to keep the recording (MCAP), or None. looks_at: files, folders and patterns of
    the course home that become evidence. plain: the environment of programs that need no ROS.
    local: False when a submission is graded. seed: the exercise's own, for its mystery. acts: name and
    detail of what the learner did while it was played. sandbox: what their programs are confined to, or None.
    judge: False where somebody else judges the recording kept in `evidence`.
    """

    exercise: str
    grader: str
    home: str
    roots: tuple[str, ...]
    packages: BuiltPackages
    environment: Mapping[str, str]
    python: str
    evidence: str | None = None
    looks_at: tuple[str, ...] = ()
    plain: Mapping[str, str] = field(default_factory=dict)
    local: bool = True
    seed: int | None = None
    acts: tuple[tuple[str, str], ...] = ()
    sandbox: Plan | None = None
    judge: bool = True


def to_line(job: Job) -> str:
    return json.dumps(asdict(job))


def from_line(line: str) -> Job:
    """Read what `to_line` wrote."""
    data: dict[str, Any] = json.loads(line)
    packages = packages_from_dict(data.pop("packages"))
    lists = {name: tuple(data[name]) for name in ("roots", "looks_at")}
    acts = tuple((name, detail) for name, detail in data.pop("acts"))
    plan = data.pop("sandbox")
    sandbox = plan_from_dict(plan) if plan else None
    return Job(**{**data, **lists}, packages=packages, acts=acts, sandbox=sandbox)

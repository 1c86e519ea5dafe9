"""What a sandbox is made of: plain data, from the parent to the grading process."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from course.arena.sandbox.limits import Limits


@dataclass(frozen=True)
class Plan:
    """user: the user id that programs get; None: the caller's own, in a user namespace.

    shown: files and folders that can be read, at their own places. hidden: what of them cannot.
    control_groups: folders of the control groups that programs are put into.
    """

    user: int | None
    shown: tuple[str, ...]
    hidden: tuple[str, ...] = ()
    control_groups: tuple[str, ...] = ()
    limits: Limits = field(default_factory=Limits)


def plan_from_dict(data: Mapping[str, Any]) -> Plan:
    """Read what dataclasses.asdict made of a plan."""
    return Plan(
        data["user"],
        tuple(data["shown"]),
        tuple(data["hidden"]),
        tuple(data["control_groups"]),
        Limits(**data["limits"]),
    )

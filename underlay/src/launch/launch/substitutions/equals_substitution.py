"""Whether two texts are the same."""

from __future__ import annotations

import math

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitutions.boolean_substitution import Logic
from launch.utilities import perform_substitutions


class EqualsSubstitution(Logic):
    """Numbers are compared as numbers, truth values without regard to case."""

    def __init__(self, left: object, right: object) -> None:
        self._sides = [texts("" if side is None else _as_text(side)) for side in (left, right)]

    def describe(self) -> str:
        sides = (" + ".join(sub.describe() for sub in side) for side in self._sides)
        return "{}({})".format(type(self).__name__, ", ".join(sides))

    def perform(self, context: LaunchContext) -> str:
        left, right = (perform_substitutions(context, side) for side in self._sides)
        return str(_same(left, right)).lower()


class NotEqualsSubstitution(EqualsSubstitution):
    def perform(self, context: LaunchContext) -> str:
        return "false" if super().perform(context) == "true" else "true"


def _as_text(side: object) -> object:
    return str(side) if isinstance(side, bool | int | float) else side


def _same(left: str, right: str) -> bool:
    if {left.lower(), right.lower()} <= {"true", "1"} or {left.lower(), right.lower()} <= {"false", "0"}:
        return True
    try:
        return math.isclose(float(left), float(right))
    except ValueError:
        return left == right

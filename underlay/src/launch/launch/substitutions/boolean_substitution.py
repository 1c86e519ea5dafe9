"""Logic: not, and, or, any, all. The result is the text `true` or `false`."""

from __future__ import annotations

from collections.abc import Iterable

from launch.action import texts
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure


class Logic(Substitution):
    """A truth value."""


def truth(context: LaunchContext, expression: Iterable[Substitution]) -> bool:
    """The truth that a text tells."""
    from launch.conditions import InvalidConditionExpressionError, evaluate_condition_expression

    try:
        return evaluate_condition_expression(context, expression)
    except InvalidConditionExpressionError as error:
        raise SubstitutionFailure(str(error)) from error


class _Several(Logic):
    def __init__(self, *parts: object) -> None:
        self._parts = [texts(part) for part in parts]

    def describe(self) -> str:
        parts = (" + ".join(sub.describe() for sub in part) for part in self._parts)
        return "{}({})".format(type(self).__name__, ", ".join(parts))

    def perform(self, context: LaunchContext) -> str:
        return str(self._holds([truth(context, part) for part in self._parts])).lower()

    def _holds(self, values: list[bool]) -> bool:
        raise NotImplementedError


class NotSubstitution(_Several):
    def __init__(self, value: object) -> None:
        super().__init__(value)

    def _holds(self, values: list[bool]) -> bool:
        return not values[0]


class AllSubstitution(_Several):
    def _holds(self, values: list[bool]) -> bool:
        return all(values)


class AnySubstitution(_Several):
    def _holds(self, values: list[bool]) -> bool:
        return any(values)


class AndSubstitution(AllSubstitution):
    def __init__(self, left: object, right: object) -> None:
        super().__init__(left, right)


class OrSubstitution(AnySubstitution):
    def __init__(self, left: object, right: object) -> None:
        super().__init__(left, right)

"""Which texts are true and which are false."""

from __future__ import annotations

from collections.abc import Iterable

from launch.conditions.invalid_condition_expression_error import InvalidConditionExpressionError
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import perform_substitutions

VALID_TRUE_EXPRESSIONS = ("true", "1")
VALID_FALSE_EXPRESSIONS = ("false", "0")


def evaluate_condition_expression(context: LaunchContext, expression: Iterable[Substitution]) -> bool:
    text = perform_substitutions(context, expression)
    if text.strip().lower() in VALID_TRUE_EXPRESSIONS:
        return True
    if text.strip().lower() in VALID_FALSE_EXPRESSIONS:
        return False
    raise InvalidConditionExpressionError(
        "invalid condition expression, expected one of '{}' (true) or '{}' (false), but got '{}'".format(
            ", ".join(VALID_TRUE_EXPRESSIONS), ", ".join(VALID_FALSE_EXPRESSIONS), text
        )
    )

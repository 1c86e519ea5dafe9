"""Unless."""

from __future__ import annotations

from launch.action import texts
from launch.condition import Condition
from launch.conditions.evaluate_condition_expression_impl import evaluate_condition_expression
from launch.launch_context import LaunchContext


class UnlessCondition(Condition):
    """Holds when the text says false or 0."""

    def __init__(self, predicate_expression: object) -> None:
        self.__expression = texts(predicate_expression)
        super().__init__(predicate=self._evaluate)

    def _evaluate(self, context: LaunchContext) -> bool:
        return not evaluate_condition_expression(context, self.__expression)

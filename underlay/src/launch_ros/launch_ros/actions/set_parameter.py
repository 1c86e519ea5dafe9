"""A parameter for all nodes that follow."""

from __future__ import annotations

from typing import Any

from launch.action import Action
from launch.launch_context import LaunchContext

from launch_ros.utilities.parameter_forms import normalize_parameters
from launch_ros.utilities.parameter_values import evaluate_parameters


class SetParameter(Action):
    """Ends with its group. A node's own parameters come after it, and win."""

    def __init__(self, name: object, value: Any, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__parameters = normalize_parameters([{name: value}])

    def execute(self, context: LaunchContext) -> None:
        (values,) = evaluate_parameters(context, self.__parameters)
        assert isinstance(values, dict)
        before = context.launch_configurations.get("global_params", [])
        # A new list: the one that was there belongs to the scope outside.
        context.launch_configurations["global_params"] = [*before, *values.items()]

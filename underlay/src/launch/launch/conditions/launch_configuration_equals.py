"""A launch configuration has a certain value."""

from __future__ import annotations

from launch.action import texts
from launch.condition import Condition
from launch.launch_context import LaunchContext
from launch.utilities import perform_substitutions


class LaunchConfigurationEquals(Condition):
    """Compares with a text; None means that the configuration is not set."""

    def __init__(self, launch_configuration_name: str, expected_value: object | None) -> None:
        self.__name = launch_configuration_name
        self.__expected = None if expected_value is None else texts(expected_value)
        super().__init__(predicate=self._evaluate)

    def _evaluate(self, context: LaunchContext) -> bool:
        expected = None if self.__expected is None else perform_substitutions(context, self.__expected)
        return context.launch_configurations.get(self.__name) == expected

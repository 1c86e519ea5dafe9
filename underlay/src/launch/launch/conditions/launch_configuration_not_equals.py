"""A launch configuration has another value."""

from __future__ import annotations

from launch.conditions.launch_configuration_equals import LaunchConfigurationEquals
from launch.launch_context import LaunchContext


class LaunchConfigurationNotEquals(LaunchConfigurationEquals):
    """The opposite of LaunchConfigurationEquals."""

    def _evaluate(self, context: LaunchContext) -> bool:
        return not super()._evaluate(context)

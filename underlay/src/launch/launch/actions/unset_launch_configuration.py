"""Take a launch configuration away."""

from launch.actions.named import Named
from launch.launch_context import LaunchContext


class UnsetLaunchConfiguration(Named):
    def execute(self, context: LaunchContext) -> None:
        context.launch_configurations.pop(self._performed_name(context), None)

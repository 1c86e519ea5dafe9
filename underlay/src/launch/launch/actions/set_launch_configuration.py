"""Give a launch configuration a value."""

from launch.actions.named import NamedValue
from launch.launch_context import LaunchContext


class SetLaunchConfiguration(NamedValue):
    def execute(self, context: LaunchContext) -> None:
        name, value = self._performed(context)
        context.launch_configurations[name] = value

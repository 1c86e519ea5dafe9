"""Take a variable away from what is started from now on."""

from launch.actions.named import Named
from launch.launch_context import LaunchContext


class UnsetEnvironmentVariable(Named):
    def execute(self, context: LaunchContext) -> None:
        context.environment.pop(self._performed_name(context), None)

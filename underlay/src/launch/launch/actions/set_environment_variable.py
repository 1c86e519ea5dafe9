"""Set a variable for what is started from now on."""

from launch.actions.named import NamedValue
from launch.launch_context import LaunchContext


class SetEnvironmentVariable(NamedValue):
    def execute(self, context: LaunchContext) -> None:
        name, value = self._performed(context)
        context.environment[name] = value

"""Back to the environment in which the launch began."""

from launch.action import Action
from launch.launch_context import LaunchContext


class ResetEnvironment(Action):
    def execute(self, context: LaunchContext) -> None:
        context._reset_environment()

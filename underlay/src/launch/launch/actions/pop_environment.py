"""Back to the environment that was put by."""

from launch.action import Action
from launch.launch_context import LaunchContext


class PopEnvironment(Action):
    def execute(self, context: LaunchContext) -> None:
        context._pop_environment()

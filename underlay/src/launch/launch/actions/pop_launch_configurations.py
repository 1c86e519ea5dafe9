"""Back to the launch configurations that were put by."""

from launch.action import Action
from launch.launch_context import LaunchContext


class PopLaunchConfigurations(Action):
    def execute(self, context: LaunchContext) -> None:
        context._pop_launch_configurations()

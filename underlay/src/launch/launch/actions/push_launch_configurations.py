"""Put by the launch configurations."""

from launch.action import Action
from launch.launch_context import LaunchContext


class PushLaunchConfigurations(Action):
    def execute(self, context: LaunchContext) -> None:
        context._push_launch_configurations()

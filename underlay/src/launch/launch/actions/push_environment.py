"""Put by the environment."""

from launch.action import Action
from launch.launch_context import LaunchContext


class PushEnvironment(Action):
    def execute(self, context: LaunchContext) -> None:
        context._push_environment()

"""Put by the environment."""

from launch.actions.named import Step
from launch.launch_context import LaunchContext


class PushEnvironment(Step):
    _step = staticmethod(LaunchContext._push_environment)

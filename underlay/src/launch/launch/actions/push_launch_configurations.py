"""Put by the launch configurations."""

from launch.actions.named import Step
from launch.launch_context import LaunchContext


class PushLaunchConfigurations(Step):
    _step = staticmethod(LaunchContext._push_launch_configurations)

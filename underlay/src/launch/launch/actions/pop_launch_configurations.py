"""Back to the launch configurations that were put by."""

from launch.actions.named import Step
from launch.launch_context import LaunchContext


class PopLaunchConfigurations(Step):
    _step = staticmethod(LaunchContext._pop_launch_configurations)

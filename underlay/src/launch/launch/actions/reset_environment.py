"""Back to the environment in which the launch began."""

from launch.actions.named import Step
from launch.launch_context import LaunchContext


class ResetEnvironment(Step):
    _step = staticmethod(LaunchContext._reset_environment)

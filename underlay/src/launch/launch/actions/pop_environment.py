"""Back to the environment that was put by."""

from launch.actions.named import Step
from launch.launch_context import LaunchContext


class PopEnvironment(Step):
    _step = staticmethod(LaunchContext._pop_environment)

"""Actions about ROS."""

from __future__ import annotations

from launch._lazy import lazily

_NAMES = {
    "Node": "node",
    "PushROSNamespace": "push_ros_namespace",
    "PushRosNamespace": "push_ros_namespace",
    "SetParameter": "set_parameter",
    "SetParametersFromFile": "set_parameters_from_file",
    "SetROSLogDir": "set_ros_log_dir",
    "SetRemap": "set_remap",
    "SetUseSimTime": "set_use_sim_time",
}
COMPONENTS = "components are C++; install ROS 2 (sudo apt install ros-jazzy-launch-ros)"
MANAGED = "managed nodes need an installed ROS 2 (sudo apt install ros-jazzy-launch-ros)"
TIMER = "use launch.actions.TimerAction, or install ROS 2 (sudo apt install ros-jazzy-launch-ros)"
_ABSENT = {
    "ComposableNodeContainer": COMPONENTS,
    "LifecycleNode": MANAGED,
    "LifecycleTransition": MANAGED,
    "LoadComposableNodes": COMPONENTS,
    "ROSTimer": TIMER,
    "RosTimer": TIMER,
}
__all__ = [*_NAMES, *_ABSENT]
__getattr__ = lazily(__name__, _NAMES, _ABSENT)

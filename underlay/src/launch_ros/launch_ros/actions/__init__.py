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
_ABSENT = {
    "ComposableNodeContainer": "components are C++; install ROS 2 (ros-jazzy-launch-ros)",
    "LifecycleNode": "managed nodes are not; install ROS 2 (ros-jazzy-launch-ros)",
    "LifecycleTransition": "managed nodes are not; install ROS 2 (ros-jazzy-launch-ros)",
    "LoadComposableNodes": "components are C++; install ROS 2 (ros-jazzy-launch-ros)",
    "ROSTimer": "use launch.actions.TimerAction, or install ROS 2 (ros-jazzy-launch-ros)",
    "RosTimer": "use launch.actions.TimerAction, or install ROS 2 (ros-jazzy-launch-ros)",
}
__all__ = list(_NAMES)
__getattr__ = lazily(__name__, _NAMES, _ABSENT)

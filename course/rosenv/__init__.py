"""Which ROS 2 is on this machine, and what a process needs to use it. No module in here imports rclpy."""

from course.files import cache_dir
from course.rosenv.environment import node_environment, plain_environment
from course.rosenv.find import find_ros
from course.rosenv.preparation import (
    add_to_underlay,
    compiled_of_underlay,
    missing_of_underlay,
    prepare,
    underlay_builds,
)
from course.rosenv.ros import Ros
from course.rosenv.setup_files import on_this_machine, places_of, setup_script

__all__ = [
    "Ros",
    "add_to_underlay",
    "cache_dir",
    "compiled_of_underlay",
    "find_ros",
    "missing_of_underlay",
    "node_environment",
    "on_this_machine",
    "places_of",
    "plain_environment",
    "prepare",
    "setup_script",
    "underlay_builds",
]

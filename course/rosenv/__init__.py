"""Which ROS 2 is here, and what a process needs to use it. No module of this room imports rclpy."""

from course.rosenv.environment import node_environment
from course.rosenv.find import find_ros
from course.rosenv.model import Ros
from course.rosenv.paths import cache_dir
from course.rosenv.preparation import prepare
from course.rosenv.setup_files import setup_script

__all__ = ["Ros", "cache_dir", "find_ros", "node_environment", "prepare", "setup_script"]

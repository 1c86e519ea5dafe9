"""The two ends of a robot's topics, for Python: they do what those of C++ do, on a node of rclpy."""

from sas_robot_driver.client import RobotDriverClient
from sas_robot_driver.server import RobotDriverServer

__all__ = ["RobotDriverClient", "RobotDriverServer"]

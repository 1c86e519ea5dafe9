"""A node's life from Python, under the names that SAS has: the node is one of rclpy.

A program calls rclcpp_init(), makes its rclcpp_Node("name"), calls rclcpp_spin_some(node) in its loop, and
rclcpp_shutdown() at the end.
"""

from sas_common.ending import quiet_after_shutdown
from sas_common.node import rclcpp_init, rclcpp_Node, rclcpp_ok, rclcpp_shutdown
from sas_common.spinning import rclcpp_spin_some

__all__ = [
    "quiet_after_shutdown",
    "rclcpp_Node",
    "rclcpp_init",
    "rclcpp_ok",
    "rclcpp_shutdown",
    "rclcpp_spin_some",
]

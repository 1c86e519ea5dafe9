"""Dual quaternions of dqrobotics as messages of geometry_msgs, and back, under the names that SAS has."""

from sas_conversions.DQ_geometry_msgs_conversions import (
    dq_to_geometry_msgs_point,
    dq_to_geometry_msgs_pose,
    dq_to_geometry_msgs_pose_stamped,
    dq_to_geometry_msgs_quaternion,
    dq_to_geometry_msgs_twist,
    dq_to_geometry_msgs_wrench,
    dq_to_geometry_msgs_wrench_stamped,
    geometry_msgs_point_to_dq,
    geometry_msgs_pose_stamped_to_dq,
    geometry_msgs_pose_to_dq,
    geometry_msgs_quaternion_to_dq,
    geometry_msgs_twist_to_dq,
    geometry_msgs_wrench_stamped_to_dq,
    geometry_msgs_wrench_to_dq,
)
from sas_conversions.std_std_msgs_conversions import double_to_std_msgs_float64, std_msgs_float64_to_double

__all__ = [
    "double_to_std_msgs_float64",
    "dq_to_geometry_msgs_point",
    "dq_to_geometry_msgs_pose",
    "dq_to_geometry_msgs_pose_stamped",
    "dq_to_geometry_msgs_quaternion",
    "dq_to_geometry_msgs_twist",
    "dq_to_geometry_msgs_wrench",
    "dq_to_geometry_msgs_wrench_stamped",
    "geometry_msgs_point_to_dq",
    "geometry_msgs_pose_stamped_to_dq",
    "geometry_msgs_pose_to_dq",
    "geometry_msgs_quaternion_to_dq",
    "geometry_msgs_twist_to_dq",
    "geometry_msgs_wrench_stamped_to_dq",
    "geometry_msgs_wrench_to_dq",
    "std_msgs_float64_to_double",
]

"""Points, quaternions, poses, wrenches and twists; what has x, y and z is an imaginary quaternion."""

from __future__ import annotations

from typing import Any

from dqrobotics import DQ, E_
from geometry_msgs.msg import Point, Pose, PoseStamped, Quaternion, Twist, Vector3, Wrench, WrenchStamped
from rclpy.node import Node


def geometry_msgs_point_to_dq(msg: Point) -> DQ:
    return _to_dq(msg)


def dq_to_geometry_msgs_point(t: DQ) -> Point:
    return Point(**_xyz(t))


def geometry_msgs_quaternion_to_dq(msg: Quaternion) -> DQ:
    """A unit one."""
    return DQ([msg.w, msg.x, msg.y, msg.z]).normalize()


def dq_to_geometry_msgs_quaternion(r: DQ) -> Quaternion:
    return Quaternion(w=r.q[0], **_xyz(r))


def geometry_msgs_pose_to_dq(msg: Pose) -> DQ:
    rotation = geometry_msgs_quaternion_to_dq(msg.orientation)
    return rotation + 0.5 * E_ * geometry_msgs_point_to_dq(msg.position) * rotation


def dq_to_geometry_msgs_pose(dq: DQ) -> Pose:
    """Of a unit dual quaternion."""
    return Pose(
        position=dq_to_geometry_msgs_point(dq.translation()),
        orientation=dq_to_geometry_msgs_quaternion(dq.rotation()),
    )


def geometry_msgs_pose_stamped_to_dq(ps: PoseStamped) -> DQ:
    return geometry_msgs_pose_to_dq(ps.pose)


def dq_to_geometry_msgs_pose_stamped(dq: DQ, node: Node | None = None) -> PoseStamped:
    """Stamped with the node's time, if there is a node."""
    return _stamped(PoseStamped(pose=dq_to_geometry_msgs_pose(dq)), node)


def geometry_msgs_wrench_to_dq(msg: Wrench) -> tuple[DQ, DQ]:
    """The force and the torque."""
    return _to_dq(msg.force), _to_dq(msg.torque)


def dq_to_geometry_msgs_wrench(force: DQ, torque: DQ) -> Wrench:
    return Wrench(force=Vector3(**_xyz(force)), torque=Vector3(**_xyz(torque)))


def geometry_msgs_wrench_stamped_to_dq(msg: WrenchStamped) -> tuple[DQ, DQ]:
    """The force and the torque."""
    return geometry_msgs_wrench_to_dq(msg.wrench)


def dq_to_geometry_msgs_wrench_stamped(force: DQ, torque: DQ, node: Node | None = None) -> WrenchStamped:
    """Stamped with the node's time, if there is a node."""
    return _stamped(WrenchStamped(wrench=dq_to_geometry_msgs_wrench(force, torque)), node)


def geometry_msgs_twist_to_dq(msg: Twist) -> tuple[DQ, DQ]:
    """The linear and the angular velocity."""
    return _to_dq(msg.linear), _to_dq(msg.angular)


def dq_to_geometry_msgs_twist(linear: DQ, angular: DQ) -> Twist:
    return Twist(linear=Vector3(**_xyz(linear)), angular=Vector3(**_xyz(angular)))


def _to_dq(message: Point | Vector3) -> DQ:
    return DQ([message.x, message.y, message.z])


def _xyz(dq: DQ) -> dict[str, float]:
    return dict(zip("xyz", dq.q[1:4].tolist(), strict=True))


def _stamped(message: Any, node: Node | None) -> Any:
    if node is not None:
        message.header.stamp = node.get_clock().now().to_msg()
    return message

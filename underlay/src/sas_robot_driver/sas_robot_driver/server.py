"""The robot's end of its topics: tells what it does, hears what it should do."""

from __future__ import annotations

from functools import partial

from numpy.typing import ArrayLike
from rclpy.node import Node
from sas_core import RobotDriver
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray, Int32MultiArray

from sas_robot_driver import topics
from sas_robot_driver.topics import Topics
from sas_robot_driver.vectors import (
    Doubles,
    Integers,
    double_message,
    doubles,
    integer_message,
    to_doubles,
    to_integers,
)

_Functionality = RobotDriver.Functionality
_SET = {
    _Functionality.PositionControl: (Float64MultiArray, topics.TARGET_JOINT_POSITIONS),
    _Functionality.VelocityControl: (Float64MultiArray, topics.TARGET_JOINT_VELOCITIES),
    _Functionality.ForceControl: (Float64MultiArray, topics.TARGET_JOINT_FORCES),
    _Functionality.Homing: (Int32MultiArray, topics.HOMING_SIGNAL),
    _Functionality.ClearPositions: (Int32MultiArray, topics.CLEAR_POSITIONS),
}


class RobotDriverServer:
    """Positions are in rad, one per joint, as arrays of numpy; lists are taken as well.

    It hears only while the node spins. What nobody has asked for yet raises RuntimeError.
    """

    def __init__(self, node: Node, topic_prefix: str = "GET_FROM_NODE") -> None:
        """Without `topic_prefix` the topics begin with the node's name."""
        self._node = node
        self._topics = Topics.of(node, topic_prefix)
        tell = self._topics.tell
        self._joint_states = tell(JointState, topics.JOINT_STATES)
        self._limits_min = tell(Float64MultiArray, topics.JOINT_POSITIONS_MIN)
        self._limits_max = tell(Float64MultiArray, topics.JOINT_POSITIONS_MAX)
        self._home_states = tell(Int32MultiArray, topics.HOME_STATES)
        self._active = _Functionality.Unavailable
        self._set = {
            mode: self._topics.hear(*topic, partial(self._activate, mode)) for mode, topic in _SET.items()
        }

    def get_topic_prefix(self) -> str:
        return self._topics.prefix

    def is_enabled(self, control_mode: _Functionality = _Functionality.PositionControl) -> bool:
        """Whether a target (or signal) of that kind has come."""
        return control_mode in self._set and self._set[control_mode].message is not None

    def get_currently_active_functionality(self) -> _Functionality:
        """The kind that came last."""
        return self._active

    def get_target_joint_positions(self) -> Doubles:
        return to_doubles(self._set[_Functionality.PositionControl].get("data"))

    def get_target_joint_velocities(self) -> Doubles:
        return to_doubles(self._set[_Functionality.VelocityControl].get("data"))

    def get_target_joint_forces(self) -> Doubles:
        return to_doubles(self._set[_Functionality.ForceControl].get("data"))

    def get_homing_signal(self) -> Integers:
        return to_integers(self._set[_Functionality.Homing].get("data"))

    def get_clear_positions_signal(self) -> Integers:
        return to_integers(self._set[_Functionality.ClearPositions].get("data"))

    def send_joint_states(
        self, joint_positions: ArrayLike, joint_velocities: ArrayLike = (), joint_forces: ArrayLike = ()
    ) -> None:
        """An empty vector stands for what the robot does not measure."""
        message = JointState(
            position=doubles(joint_positions),
            velocity=doubles(joint_velocities),
            effort=doubles(joint_forces),
        )
        message.header.stamp = self._node.get_clock().now().to_msg()
        self._joint_states(message)

    def send_joint_limits(self, joint_limits: tuple[ArrayLike, ArrayLike]) -> None:
        """Least and greatest positions."""
        least, greatest = joint_limits
        self._limits_min(double_message(least))
        self._limits_max(double_message(greatest))

    def send_home_state(self, home_state: ArrayLike) -> None:
        self._home_states(integer_message(home_state))

    def _activate(self, mode: _Functionality) -> None:
        self._active = mode

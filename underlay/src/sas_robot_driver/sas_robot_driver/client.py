"""The end of a robot's topics for programs that want to know what it does, and command it."""

from __future__ import annotations

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
    integer_message,
    to_doubles,
    to_integers,
)

_Functionality = RobotDriver.Functionality


class RobotDriverClient:
    """Positions are in rad, one per joint, as arrays of numpy; lists are taken as well.

    It hears only while the node spins. What the robot has not told yet raises RuntimeError.
    """

    def __init__(self, node: Node, topic_prefix: str = "GET_FROM_NODE") -> None:
        """`topic_prefix` is the name of the robot's node; without it, it is the name of this node."""
        self._topics = Topics.of(node, topic_prefix)
        hear, tell = self._topics.hear, self._topics.tell
        self._joint_states = hear(JointState, topics.JOINT_STATES)
        self._limits_min = hear(Float64MultiArray, topics.JOINT_POSITIONS_MIN)
        self._limits_max = hear(Float64MultiArray, topics.JOINT_POSITIONS_MAX)
        self._home_states = hear(Int32MultiArray, topics.HOME_STATES)
        self._target_joint_positions = tell(Float64MultiArray, topics.TARGET_JOINT_POSITIONS)
        self._target_joint_velocities = tell(Float64MultiArray, topics.TARGET_JOINT_VELOCITIES)
        self._target_joint_forces = tell(Float64MultiArray, topics.TARGET_JOINT_FORCES)
        self._homing_signal = tell(Int32MultiArray, topics.HOMING_SIGNAL)
        self._clear_positions = tell(Int32MultiArray, topics.CLEAR_POSITIONS)

    def get_topic_prefix(self) -> str:
        return self._topics.prefix

    def is_enabled(self, control_mode: _Functionality = _Functionality.PositionControl) -> bool:
        """Whether the robot has told what is needed: its state, and for positions their limits, too."""
        if control_mode is _Functionality.PositionControl:
            limits = (self._limits_min, self._limits_max)
            return self._joint_states.has("position") and all(one.message is not None for one in limits)
        if control_mode is _Functionality.VelocityControl:
            return self._joint_states.has("velocity")
        if control_mode is _Functionality.ForceControl:
            return self._joint_states.has("effort")
        return control_mode is not _Functionality.Unavailable and self._home_states.message is not None

    def get_joint_positions(self) -> Doubles:
        return to_doubles(self._joint_states.get("position"))

    def get_joint_velocities(self) -> Doubles:
        return to_doubles(self._joint_states.get("velocity"))

    def get_joint_forces(self) -> Doubles:
        return to_doubles(self._joint_states.get("effort"))

    def get_joint_limits(self) -> tuple[Doubles, Doubles]:
        """Least and greatest positions."""
        return to_doubles(self._limits_min.get("data")), to_doubles(self._limits_max.get("data"))

    def get_home_states(self) -> Integers:
        return to_integers(self._home_states.get("data"))

    def send_target_joint_positions(self, target_joint_positions: ArrayLike) -> None:
        self._target_joint_positions(double_message(target_joint_positions))

    def send_target_joint_velocities(self, target_joint_velocities: ArrayLike) -> None:
        self._target_joint_velocities(double_message(target_joint_velocities))

    def send_target_joint_forces(self, target_joint_forces: ArrayLike) -> None:
        self._target_joint_forces(double_message(target_joint_forces))

    def send_homing_signal(self, homing_signal: ArrayLike) -> None:
        self._homing_signal(integer_message(homing_signal))

    def send_clear_positions_signal(self, clear_positions_signal: ArrayLike) -> None:
        self._clear_positions(integer_message(clear_positions_signal))

"""A robot with six joints on a driver's topics: it reaches each target at once, and reports it at 100 Hz.

Its joints start at different positions: a script that does not read them sends wrong targets.
"""

from __future__ import annotations

import contextlib
import math
import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray, Int32MultiArray

PERIOD = 0.01
BEGIN = (0.3, -0.2, 0.5, -0.4, 0.1, 0.25)
LIMITS = [2 * math.pi] * 5 + [4 * math.pi]


class Robot(Node):
    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.positions = list(BEGIN)
        topic = f"/{name}/{{}}".format
        states = self.create_publisher(JointState, topic("get/joint_states"), 10)
        least = self.create_publisher(Float64MultiArray, topic("get/joint_positions_min"), 10)
        greatest = self.create_publisher(Float64MultiArray, topic("get/joint_positions_max"), 10)
        homes = self.create_publisher(Int32MultiArray, topic("get/home_states"), 10)
        self.create_subscription(Float64MultiArray, topic("set/target_joint_positions"), self.move, 1000)

        def tell() -> None:
            states.publish(JointState(position=self.positions))
            least.publish(Float64MultiArray(data=[-limit for limit in LIMITS]))
            greatest.publish(Float64MultiArray(data=LIMITS))
            homes.publish(Int32MultiArray(data=[0] * len(BEGIN)))

        self.create_timer(PERIOD, tell)

    def move(self, target: Float64MultiArray) -> None:
        if len(target.data) == len(BEGIN):
            self.positions = list(target.data)


def main() -> None:
    rclpy.init()
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(Robot(sys.argv[1]))


if __name__ == "__main__":
    main()

"""A program in the way of the tutorial: commands a robot from Python, with the real dqrobotics."""

import math
import time

from dqrobotics import *  # noqa: F403  # as such programs do
from dqrobotics.utils.DQ_Math import deg2rad
from sas_common import rclcpp_init, rclcpp_Node, rclcpp_shutdown, rclcpp_spin_some
from sas_core import Clock, Statistics
from sas_robot_driver import RobotDriverClient


def main() -> None:
    rclcpp_init()
    node = rclcpp_Node("joint_interface_example")
    robot = RobotDriverClient(node, "myrobot_1")
    print("waiting", flush=True)
    while not robot.is_enabled():
        rclcpp_spin_some(node)
        time.sleep(0.01)
    initial = robot.get_joint_positions()
    clock = Clock(0.01)
    clock.init()
    target = initial
    for i in range(100):
        clock.update_and_sleep()
        target = initial + deg2rad([10.0 * math.sin(i / (50.0 * math.pi))] * 6)
        robot.send_target_joint_positions(target)
        rclcpp_spin_some(node)
    while (robot.get_joint_positions() != target).any():
        robot.send_target_joint_positions(target)
        clock.update_and_sleep()
        rclcpp_spin_some(node)
    print(initial.tolist(), robot.get_joint_positions().tolist())
    print(clock.get_statistics(Statistics.Mean, Clock.TimeType.Computational) > 0)
    rclcpp_shutdown()


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        print("interrupted")

#!/usr/bin/env python3
import sys
from math import pi, radians, sin

from rclpy.executors import ExternalShutdownException
from sas_common import rclcpp_init, rclcpp_Node, rclcpp_shutdown, rclcpp_spin_some
from sas_core import Clock
from sas_robot_driver import RobotDriverClient


def main():
    rclcpp_init()
    node = rclcpp_Node('swing')
    robot = RobotDriverClient(topic_prefix='/myrobot_1', node=node)
    clock = Clock(0.01)
    clock.init()
    while not robot.is_enabled():
        clock.update_and_sleep()
        rclcpp_spin_some(node)
    beginning = list(robot.get_joint_positions())
    i = 0
    clock.init()
    while i < 5000:
        swing = radians(10 * sin(i / (50 * pi)))
        robot.send_target_joint_positions([joint + swing for joint in beginning])
        rclcpp_spin_some(node)
        clock.update_and_sleep()
        i += 1
    rclcpp_shutdown()


try:
    main()
except (KeyboardInterrupt, ExternalShutdownException):
    sys.exit(0)

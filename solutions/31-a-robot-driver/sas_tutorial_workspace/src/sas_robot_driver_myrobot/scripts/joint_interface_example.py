#!/usr/bin/python3
"""Swing all six joints of myrobot_1 by ten degrees."""

import math
import time

from dqrobotics.utils.DQ_Math import deg2rad
from sas_common import rclcpp_init, rclcpp_Node, rclcpp_shutdown, rclcpp_spin_some
from sas_core import Clock, Statistics
from sas_robot_driver import RobotDriverClient


def main():
    """Wait for the robot, then send it 100 targets per second until Ctrl+C."""
    rclcpp_init()
    node = rclcpp_Node('joint_interface_example')
    robot = RobotDriverClient(node, 'myrobot_1')
    while not robot.is_enabled():
        rclcpp_spin_some(node)
        time.sleep(0.1)

    print(f'topic prefix: {robot.get_topic_prefix()}')
    initial = robot.get_joint_positions()
    print(f'joint positions: {initial}')

    clock = Clock(0.01)
    clock.init()
    for i in range(5000):
        clock.update_and_sleep()
        swing = deg2rad([10.0 * math.sin(i / (50.0 * math.pi))] * 6)
        robot.send_target_joint_positions(initial + swing)
        rclcpp_spin_some(node)

    print('On average, in seconds:')
    for name, time_type in (
        ('computing', Clock.TimeType.Computational),
        ('idle', Clock.TimeType.Idle),
        ('sampling time', Clock.TimeType.EffectiveSampling),
    ):
        print(f'  {name}: {clock.get_statistics(Statistics.Mean, time_type):.6f}')
    rclcpp_shutdown()


if __name__ == '__main__':
    try:
        main()
    except KeyboardInterrupt:
        pass

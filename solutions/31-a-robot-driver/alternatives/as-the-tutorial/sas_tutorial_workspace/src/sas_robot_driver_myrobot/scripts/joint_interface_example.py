#!/usr/bin/python3
from math import pi, sin
from time import sleep

from dqrobotics import *
from dqrobotics.utils.DQ_Math import deg2rad
from sas_common import rclcpp_init, rclcpp_Node, rclcpp_shutdown, rclcpp_spin_some
from sas_core import Clock, Statistics
from sas_robot_driver import RobotDriverClient


def swing(node, robot, clock):
    """Move all joints by ten degrees around the start, in 5000 cycles."""
    start = robot.get_joint_positions()
    print(f'{robot.get_topic_prefix()} starts at {start}')
    for cycle in range(5000):
        clock.update_and_sleep()
        degrees = 10.0 * sin(cycle / (50.0 * pi))
        robot.send_target_joint_positions(start + deg2rad([degrees] * 6))
        rclcpp_spin_some(node)


def main(args=None):
    try:
        rclcpp_init()
        node = rclcpp_Node('swings_all_joints')
        clock = Clock(0.01)
        clock.init()
        robot = RobotDriverClient(node, 'myrobot_1')
        while not robot.is_enabled():
            rclcpp_spin_some(node)
            sleep(0.1)
        swing(node, robot, clock)
        for kind in (Clock.TimeType.Computational, Clock.TimeType.Idle):
            print(kind, clock.get_statistics(Statistics.Mean, kind))
        rclcpp_shutdown()
    except KeyboardInterrupt:
        print('Stopped with Ctrl+C')
    except Exception as problem:
        print('Stopped by', problem)


if __name__ == '__main__':
    main()

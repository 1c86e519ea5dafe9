#!/usr/bin/python3
import time
from math import pi, sin

from dqrobotics import *
from dqrobotics.utils.DQ_Math import deg2rad
from sas_common import rclcpp_init, rclcpp_Node, rclcpp_shutdown, rclcpp_spin_some
from sas_core import Clock, Statistics
from sas_robot_driver import RobotDriverClient


def main(args=None):
    try:
        rclcpp_init()
        node = rclcpp_Node("sas_robot_driver_myrobot_joint_space_example_node_cpp")

        clock = Clock(0.01)
        clock.init()

        rdi = RobotDriverClient(node, 'myrobot_1')

        while not rdi.is_enabled():
            rclcpp_spin_some(node)
            time.sleep(0.1)

        print(f"topic prefix = {rdi.get_topic_prefix()}")

        joint_positions = rdi.get_joint_positions()
        print(f"joint positions = {joint_positions}")

        for i in range(0, 5000):
            clock.update_and_sleep()

            target_joint_positions = joint_positions + deg2rad([10.0 * sin(i / (50.0 * pi))] * 6)
            rdi.send_target_joint_positions(target_joint_positions)

            rclcpp_spin_some(node)

        print("Means of the loop")
        print("  computing: {}".format(clock.get_statistics(Statistics.Mean, Clock.TimeType.Computational)))
        print("  idle: {}".format(clock.get_statistics(Statistics.Mean, Clock.TimeType.Idle)))

        rclcpp_shutdown()

    except KeyboardInterrupt:
        print("Ended by the user")
    except Exception as e:
        print("Unhandled exception", e)


if __name__ == '__main__':
    main()

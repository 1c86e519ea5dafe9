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
        node = rclcpp_Node("joint_interface_example")

        rdi = RobotDriverClient(node, 'myrobot_1')
        while not rdi.is_enabled():
            rclcpp_spin_some(node)
            time.sleep(0.1)

        clock = Clock(0.01)
        clock.init()

        i = 0
        q0 = rdi.get_joint_positions()
        for i in range(0, 5000):
            clock.update_and_sleep()
            q = q0 + deg2rad([10.0 * sin(i / (50.0 * pi)) for _ in range(6)])
            rdi.send_target_joint_positions(q)
            rclcpp_spin_some(node)

        mean = clock.get_statistics(Statistics.Mean, Clock.TimeType.EffectiveSampling)
        print("Mean effective sampling: {}".format(mean))
        rclcpp_shutdown()

    except KeyboardInterrupt:
        print("Interrupted by user")
    except Exception as e:
        print("Unhandled exception", e)


if __name__ == '__main__':
    main()

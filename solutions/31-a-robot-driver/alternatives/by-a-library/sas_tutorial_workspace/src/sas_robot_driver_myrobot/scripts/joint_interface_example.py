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

        arm = RobotDriverClient(node, 'myrobot_1')
        while not arm.is_enabled():
            rclcpp_spin_some(node)
            time.sleep(0.1)
        q0 = arm.get_joint_positions()

        clock = Clock(0.01)
        clock.init()
        i = 0
        while i < 5000:
            clock.update_and_sleep()
            arm.send_target_joint_positions(q0 + deg2rad([10.0 * sin(i / (50.0 * pi)) for _ in range(6)]))
            rclcpp_spin_some(node)
            i += 1

        print(clock.get_statistics(Statistics.Mean, Clock.TimeType.EffectiveSampling), "s per cycle")
        rclcpp_shutdown()

    except KeyboardInterrupt:
        print("Enough.")
    except Exception as e:
        print("Something else went wrong:", e)


if __name__ == '__main__':
    main()

"""A driver with its own loop instead of a timer."""

import numpy as np
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray, Int32MultiArray

DOUBLES = ('target_joint_positions', 'target_joint_velocities', 'target_joint_forces')
INTEGERS = ('homing_signal', 'clear_positions')


class WrongTarget(Exception):
    """A target that does not fit the robot."""


def ignore(message):
    """Ignore a command that this robot does not support."""


def run(node):
    """Publish and move until Ctrl+C."""
    name = node.get_name()
    node.declare_parameters('', [
        ('ip', ''),
        ('joint_limits_min', [-360.0] * 6),
        ('joint_limits_max', [360.0] * 6),
        ('thread_sampling_time_sec', 0.01),
    ])
    limits = {
        end: np.deg2rad(node.get_parameter(f'joint_limits_{end}').value).tolist() for end in ('min', 'max')
    }
    state = JointState(position=[0.0] * 6)

    def move(message):
        if len(message.data) != 6:
            raise WrongTarget(f'{len(message.data)} joints')
        state.position = message.data

    heard = [
        node.create_subscription(
            Float64MultiArray, f'{name}/set/{topic}', move if topic == DOUBLES[0] else ignore, 10)
        for topic in DOUBLES
    ]
    heard += [
        node.create_subscription(Int32MultiArray, f'{name}/set/{topic}', ignore, 10) for topic in INTEGERS
    ]
    told = node.create_publisher(JointState, f'{name}/get/joint_states', 10)
    ends = {
        end: node.create_publisher(Float64MultiArray, f'{name}/get/joint_positions_{end}', 10)
        for end in limits
    }
    homes = node.create_publisher(Int32MultiArray, f'{name}/get/home_states', 10)

    def tell():
        told.publish(state)
        homes.publish(Int32MultiArray(data=[0] * 6))
        for end, publisher in ends.items():
            publisher.publish(Float64MultiArray(data=limits[end]))

    node.create_timer(node.get_parameter('thread_sampling_time_sec').value, tell)
    while rclpy.ok():
        rclpy.spin_once(node)


def main():
    """Shut down the robot, no matter what happened."""
    rclpy.init()
    node = Node('myrobot_2')
    try:
        run(node)
    except WrongTarget as error:
        node.get_logger().fatal(f'a wrong target: {error}')
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    print('[robot] Motor off', flush=True)
    print('[robot] Disconnected', flush=True)

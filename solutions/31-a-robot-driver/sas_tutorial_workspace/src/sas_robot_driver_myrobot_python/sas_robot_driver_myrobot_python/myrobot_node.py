"""The driver of a robot with six joints, which exists only in memory."""

import math

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray, Int32MultiArray

JOINTS = 6


class MyrobotNode(Node):
    """Publishes the positions of the joints, and moves them to each target."""

    def __init__(self):
        """Declare the parameters, and create the publishers, the subscriptions, and the timer."""
        super().__init__('myrobot_2')
        self.positions = [0.0] * JOINTS
        self.ip = self.declare_parameter('ip', '127.0.0.1').value
        self.least = self.limits('joint_limits_min', -360.0)
        self.greatest = self.limits('joint_limits_max', 360.0)
        period = self.declare_parameter('thread_sampling_time_sec', 0.01).value

        self.states_publisher = self.create_publisher(JointState, '~/get/joint_states', 10)
        self.least_publisher = self.create_publisher(Float64MultiArray, '~/get/joint_positions_min', 10)
        self.greatest_publisher = self.create_publisher(Float64MultiArray, '~/get/joint_positions_max', 10)
        self.home_publisher = self.create_publisher(Int32MultiArray, '~/get/home_states', 10)

        self.create_subscription(Float64MultiArray, '~/set/target_joint_positions', self.move, 10)
        self.create_subscription(Float64MultiArray, '~/set/target_joint_velocities', self.ignore, 10)
        self.create_subscription(Float64MultiArray, '~/set/target_joint_forces', self.ignore, 10)
        self.create_subscription(Int32MultiArray, '~/set/homing_signal', self.ignore, 10)
        self.create_subscription(Int32MultiArray, '~/set/clear_positions', self.ignore, 10)

        self.timer = self.create_timer(period, self.tell)

    def limits(self, name, default):
        """Convert the limits in this parameter from degrees to a message in radians."""
        degrees = self.declare_parameter(name, [default] * JOINTS).value
        return Float64MultiArray(data=[math.radians(limit) for limit in degrees])

    def tell(self):
        """Publish the state of the robot once."""
        state = JointState(position=self.positions)
        state.header.stamp = self.get_clock().now().to_msg()
        self.states_publisher.publish(state)
        self.least_publisher.publish(self.least)
        self.greatest_publisher.publish(self.greatest)
        self.home_publisher.publish(Int32MultiArray(data=[0] * JOINTS))

    def move(self, target):
        """Move to the target. Raise ValueError if it does not fit the robot."""
        if len(target.data) != JOINTS:
            raise ValueError(f'A target needs {JOINTS} joint positions; this one has {len(target.data)}.')
        self.positions = list(target.data)

    def ignore(self, message):
        """Ignore a command that this robot does not support."""


def main(args=None):
    """Spin the driver until Ctrl+C, or until a target does not fit the robot."""
    rclpy.init(args=args)
    node = MyrobotNode()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    except ValueError as error:
        node.get_logger().error(str(error))
    finally:
        print('Motor off.', flush=True)
        print('Disconnected.', flush=True)


if __name__ == '__main__':
    main()

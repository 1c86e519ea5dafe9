"""The driver of a robot with six joints, which exists only in memory."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class MyrobotNode(Node):
    """Publish the positions of the joints, and move them to each target."""

    def __init__(self):
        """Declare the parameters, and create the publishers, the subscriptions, and the timer."""
        super().__init__('myrobot_2')
        # TODO


def main(args=None):
    """Spin the driver until Ctrl+C, or until a target does not fit the robot."""
    rclpy.init(args=args)
    try:
        rclpy.spin(MyrobotNode())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    # TODO: no matter how it ended, print "Motor off." and then "Disconnected."


if __name__ == '__main__':
    main()

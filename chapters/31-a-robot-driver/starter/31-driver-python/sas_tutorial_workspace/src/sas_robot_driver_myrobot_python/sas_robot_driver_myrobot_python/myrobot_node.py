"""The driver of a robot of six joints, which exists in memory only."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class MyrobotNode(Node):
    """Tells where the joints are, and goes where it is told."""

    def __init__(self):
        """Declare the parameters, and make publishers, subscriptions and the timer."""
        super().__init__('myrobot_2')
        # TODO


def main(args=None):
    """Spin the driver until Ctrl+C, or until a target does not fit the robot."""
    rclpy.init(args=args)
    try:
        rclpy.spin(MyrobotNode())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    # TODO: in whatever way it ended: motor off, then disconnected


if __name__ == '__main__':
    main()

"""The node range_sensor publishes the distance to the wall ten times per second."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

# TODO 1: import Twist and Range.

PERIOD = 0.1  # seconds


class RangeSensor(Node):
    """Replaces a real sensor: it calculates the distance from the rover's speed."""

    def __init__(self):
        super().__init__('range_sensor')
        self.distance = 3.0
        self.speed = 0.0
        # TODO 2: create the publisher, the subscription, and the timer.

    def command_callback(self, message):
        """Store the rover's new speed."""
        # TODO 3

    def timer_callback(self):
        """Move closer to the wall, and publish the remaining distance."""
        # TODO 4


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(RangeSensor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

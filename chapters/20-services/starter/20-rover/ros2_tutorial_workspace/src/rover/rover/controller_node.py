"""The node controller drives the rover toward the wall and stops in front of it."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

# TODO 1: import safe_speed from your library, and the messages and the service.


class Controller(Node):
    """Listens to the sensor and commands the speed that the library calculates."""

    def __init__(self):
        super().__init__('controller')
        self.stopped = False
        # TODO 2: create the publisher, the subscription, and the service.

    def range_callback(self, message):
        """Publish a speed for each measurement."""
        # TODO 3

    def stop_callback(self, request, response):
        """Stop the rover, or let it drive again."""
        # TODO 4
        return response


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(Controller())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

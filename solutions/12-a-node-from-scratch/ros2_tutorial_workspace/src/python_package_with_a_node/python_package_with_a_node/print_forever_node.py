"""The node print_forever logs twice per second how many messages it has logged so far."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

PERIOD = 0.5  # seconds


class PrintForever(Node):
    """Counts its own log messages, from zero and forever."""

    def __init__(self):
        super().__init__('print_forever')
        self.count = 0
        self.timer = self.create_timer(PERIOD, self.timer_callback)

    def timer_callback(self):
        """Log the count, then add one to it."""
        self.get_logger().info(f'Printed {self.count} times.')
        self.count += 1


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(PrintForever())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

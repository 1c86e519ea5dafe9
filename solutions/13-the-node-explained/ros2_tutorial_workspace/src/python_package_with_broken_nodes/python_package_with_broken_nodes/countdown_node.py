"""
The node countdown: it logs 3, 2, 1 and "Lift-off!", one every half a second.

After that it keeps running without output. Ctrl+C ends it, without a traceback.
"""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

PERIOD = 0.5  # seconds


class Countdown(Node):
    """Counts down from three, once."""

    def __init__(self):
        super().__init__('countdown')
        self.left = 3
        self.timer = self.create_timer(PERIOD, self.count_down)

    def count_down(self):
        """Say the next number; after the last one, stop the timer."""
        if self.left > 0:
            self.get_logger().info(f'{self.left}')
            self.left -= 1
        else:
            self.get_logger().info('Lift-off!')
            self.timer.cancel()


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(Countdown())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

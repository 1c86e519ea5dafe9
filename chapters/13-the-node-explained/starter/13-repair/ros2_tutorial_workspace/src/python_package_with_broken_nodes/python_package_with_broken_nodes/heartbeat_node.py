"""
The node heartbeat: it logs "Still alive." twice per second, forever.

Ctrl+C ends it, without a traceback.
"""
# TODO: one thing in this file is wrong. Run it, see what it does, and fix it.

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

PERIOD = 0.5  # seconds


class Heartbeat(Node):
    """Tells the other nodes that it is still running."""

    def __init__(self):
        super().__init__('heartbeat')
        self.timer = self.create_timer(PERIOD, self.beat)

    def beat(self):
        """Log it once."""
        self.get_logger().info('Still alive.')


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        Heartbeat()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

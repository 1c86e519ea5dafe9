"""
The node scanner: it logs "The way is clear." twice per second, with its laser on.

Ctrl+C ends it, without a traceback. Before it ends, it switches off its laser and
prints "The laser is off.".
"""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

PERIOD = 0.5  # seconds


class Scanner(Node):
    """Looks ahead with a laser that must not stay on."""

    def __init__(self):
        super().__init__('scanner')
        self.laser_is_on = True
        self.timer = self.create_timer(PERIOD, self.report)

    def report(self):
        """Log what is ahead."""
        self.get_logger().info('The way is clear.')

    def switch_off_the_laser(self):
        """Switch it off. Print instead of logging: when the node ends, its logger no longer works."""
        self.laser_is_on = False
        print('The laser is off.')


def main(args=None):
    """Run the node until Ctrl+C, then switch off its laser."""
    rclpy.init(args=args)
    scanner = Scanner()
    try:
        rclpy.spin(scanner)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        scanner.switch_off_the_laser()
        scanner.destroy_node()
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()

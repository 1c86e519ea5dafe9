"""
The node night_watch: it logs "All is quiet." twice per second, by lamplight.

Ctrl+C ends it, without a traceback. Before it ends, it puts out its lamp and
prints "The lamp is off.".
"""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

PERIOD = 0.5  # seconds


class NightWatch(Node):
    """Keeps watch, with a lamp that must not stay on."""

    def __init__(self):
        super().__init__('night_watch')
        self.lamp_is_on = True
        self.timer = self.create_timer(PERIOD, self.report)

    def report(self):
        """Say what is to be seen."""
        self.get_logger().info('All is quiet.')

    def put_out_the_lamp(self):
        """Do so, and print it: at the end of a node its logger is gone."""
        self.lamp_is_on = False
        print('The lamp is off.')


def main(args=None):
    """Run the node until Ctrl+C, then put out its lamp."""
    rclpy.init(args=args)
    night_watch = NightWatch()
    try:
        rclpy.spin(night_watch)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        night_watch.put_out_the_lamp()
        night_watch.destroy_node()
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()

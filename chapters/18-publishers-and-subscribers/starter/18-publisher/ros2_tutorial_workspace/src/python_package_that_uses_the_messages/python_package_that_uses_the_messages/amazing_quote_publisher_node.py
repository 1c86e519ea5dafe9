"""The node amazing_quote_publisher_node publishes an AmazingQuote twice per second."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

# TODO 1: import AmazingQuote from the package that you made in chapter 17.


class AmazingQuotePublisher(Node):
    """Publishes numbered quotes on /amazing_quote."""

    def __init__(self):
        super().__init__('amazing_quote_publisher_node')
        # TODO 2: create the publisher, a number that starts at 0, and a timer of
        #   0.5 seconds that calls timer_callback.

    def timer_callback(self):
        """Publish the next quote."""
        # TODO 3: make a message, set id, quote, and philosopher_name, publish it,
        #   and add one to the number.


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(AmazingQuotePublisher())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

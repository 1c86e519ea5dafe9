"""The node amazing_quote_publisher_node: an AmazingQuote twice per second."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

# TODO 1: import AmazingQuote from the package that you made in chapter 17.


class AmazingQuotePublisher(Node):
    """Publishes numbered quotes on /amazing_quote."""

    def __init__(self):
        super().__init__('amazing_quote_publisher_node')
        # TODO 2: create the publisher, the number of the first message, and a
        #   timer of 0.5 seconds that calls timer_callback.

    def timer_callback(self):
        """Publish the next quote."""
        # TODO 3: make a message, fill in id, quote and philosopher_name, publish
        #   it, and move the number on.


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(AmazingQuotePublisher())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

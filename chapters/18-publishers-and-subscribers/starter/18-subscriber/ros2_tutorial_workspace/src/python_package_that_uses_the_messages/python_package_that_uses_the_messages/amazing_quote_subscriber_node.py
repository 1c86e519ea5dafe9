"""The node amazing_quote_subscriber_node logs every AmazingQuote that it receives."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

# TODO 1: import AmazingQuote.


class AmazingQuoteSubscriber(Node):
    """Listens to /amazing_quote."""

    def __init__(self):
        super().__init__('amazing_quote_subscriber_node')
        # TODO 2: create the subscription; it calls quote_callback.

    # TODO 3: write quote_callback, which logs the quote, the philosopher's name,
    #   and the id of its message.


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(AmazingQuoteSubscriber())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

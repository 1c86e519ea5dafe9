"""The node amazing_quote_subscriber_node logs every AmazingQuote that it receives."""

import rclpy
from package_with_interfaces.msg import AmazingQuote
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class AmazingQuoteSubscriber(Node):
    """Listens to /amazing_quote."""

    def __init__(self):
        super().__init__('amazing_quote_subscriber_node')
        self.subscription = self.create_subscription(
            AmazingQuote, '/amazing_quote', self.quote_callback, 10)

    def quote_callback(self, message):
        """Log all three parts of one quote."""
        self.get_logger().info(
            f'Quote {message.id}: "{message.quote}" ({message.philosopher_name})')


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(AmazingQuoteSubscriber())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

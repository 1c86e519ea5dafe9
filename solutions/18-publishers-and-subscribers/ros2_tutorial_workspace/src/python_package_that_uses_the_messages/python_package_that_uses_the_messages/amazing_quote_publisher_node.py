"""The node amazing_quote_publisher_node publishes an AmazingQuote twice per second."""

import rclpy
from package_with_interfaces.msg import AmazingQuote
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

PERIOD = 0.5  # seconds
QUOTES = (
    ('Measure twice, publish once.', 'A careful carpenter'),
    ('A robot at rest has published all it knows.', 'The night shift'),
    ('Whoever listens first misses nothing.', 'An early subscriber'),
)


class AmazingQuotePublisher(Node):
    """Publishes QUOTES again and again, with a number for each message."""

    def __init__(self):
        super().__init__('amazing_quote_publisher_node')
        self.publisher = self.create_publisher(AmazingQuote, '/amazing_quote', 10)
        self.next_id = 0
        self.timer = self.create_timer(PERIOD, self.timer_callback)

    def timer_callback(self):
        """Publish the next quote."""
        quote, philosopher_name = QUOTES[self.next_id % len(QUOTES)]
        message = AmazingQuote()
        message.id = self.next_id
        message.quote = quote
        message.philosopher_name = philosopher_name
        self.publisher.publish(message)
        self.next_id += 1


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(AmazingQuotePublisher())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

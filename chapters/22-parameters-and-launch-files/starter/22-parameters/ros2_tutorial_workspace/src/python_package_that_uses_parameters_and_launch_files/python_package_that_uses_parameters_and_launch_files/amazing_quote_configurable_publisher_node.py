"""The node amazing_quote_configurable_publisher_node publishes what its parameters say."""

import rclpy
from package_with_interfaces.msg import AmazingQuote
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class AmazingQuoteConfigurablePublisher(Node):
    """Publishes a quote again and again. Its parameters set the text, topic, and period."""

    def __init__(self):
        super().__init__('amazing_quote_configurable_publisher_node')
        # TODO 1: declare the parameters quote, philosopher_name, topic_name, and
        #   period, each with its default value.
        # TODO 2: read topic_name and period, and use them in the lines below.
        self.publisher = self.create_publisher(AmazingQuote, 'stubborn_quote', 10)
        self.next_id = 0
        self.timer = self.create_timer(1.0, self.timer_callback)

    def timer_callback(self):
        """Publish the current values of the parameters."""
        message = AmazingQuote()
        message.id = self.next_id
        # TODO 3: read quote and philosopher_name here, for each message.
        message.quote = 'Nobody can change what I say.'
        message.philosopher_name = 'A stubborn node'
        self.publisher.publish(message)
        self.next_id += 1


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(AmazingQuoteConfigurablePublisher())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

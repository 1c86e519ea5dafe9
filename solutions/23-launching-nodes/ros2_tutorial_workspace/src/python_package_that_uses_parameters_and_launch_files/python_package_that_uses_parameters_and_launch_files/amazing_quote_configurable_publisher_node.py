"""The node amazing_quote_configurable_publisher_node publishes what its parameters say."""

import rclpy
from package_with_interfaces.msg import AmazingQuote
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class AmazingQuoteConfigurablePublisher(Node):
    """Publishes a quote again and again. Its parameters set the text, topic, and period."""

    def __init__(self):
        super().__init__('amazing_quote_configurable_publisher_node')
        self.declare_parameter('quote', 'Use the force, Pikachu!')
        self.declare_parameter('philosopher_name', 'Uncle Ben')
        self.declare_parameter('topic_name', 'amazing_quote')
        self.declare_parameter('period', 0.5)  # seconds
        topic_name = self.get_parameter('topic_name').value
        period = self.get_parameter('period').value
        self.publisher = self.create_publisher(AmazingQuote, topic_name, 10)
        self.next_id = 0
        self.timer = self.create_timer(period, self.timer_callback)

    def timer_callback(self):
        """Publish the current values of the parameters."""
        message = AmazingQuote()
        message.id = self.next_id
        message.quote = self.get_parameter('quote').value
        message.philosopher_name = self.get_parameter('philosopher_name').value
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

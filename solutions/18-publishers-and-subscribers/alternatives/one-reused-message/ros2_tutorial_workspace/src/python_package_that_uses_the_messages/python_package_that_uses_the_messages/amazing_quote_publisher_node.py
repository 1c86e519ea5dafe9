from itertools import count

import rclpy
from package_with_interfaces.msg import AmazingQuote
from rclpy.executors import ExternalShutdownException


def main():
    rclpy.init()
    node = rclpy.create_node('amazing_quote_publisher_node')
    publisher = node.create_publisher(AmazingQuote, 'amazing_quote', 10)
    message = AmazingQuote(quote='Same again.', philosopher_name='The regular')
    ids = count()

    def serve():
        message.id = next(ids)
        publisher.publish(message)

    timer = node.create_timer(0.5, serve)
    try:
        while rclpy.ok():
            rclpy.spin_once(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        timer.cancel()

import sys

import rclpy
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor

from .nodes import Listener, Talker


def run(kind, name):
    rclpy.init(args=sys.argv)
    executor = MultiThreadedExecutor(num_threads=2)
    executor.add_node(kind(name))
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        sys.exit(130)


def publisher():
    run(Talker, 'amazing_quote_publisher_node')


def subscriber():
    run(Listener, 'amazing_quote_subscriber_node')

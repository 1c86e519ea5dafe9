from functools import partial

import rclpy
from rclpy.executors import ExternalShutdownException


def spin(node, at_the_end=lambda: None):
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        at_the_end()


def say(node, text):
    node.get_logger().info(text)


def heartbeat():
    rclpy.init()
    node = rclpy.create_node('heartbeat')
    node.create_timer(0.5, partial(say, node, 'Still alive.'))
    spin(node)


def countdown():
    rclpy.init()
    node = rclpy.create_node('countdown')
    words = iter(['3', '2', '1', 'Lift-off!'])

    def tick():
        for word in words:
            say(node, word)
            return

    node.create_timer(0.5, tick)
    spin(node)


def scanner():
    rclpy.init()
    node = rclpy.create_node('scanner')
    node.create_timer(0.5, lambda: say(node, 'The way is clear.'))
    spin(node, partial(say, node, 'The laser is off.'))

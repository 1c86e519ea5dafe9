from functools import partial
from itertools import count

import package_with_interfaces.msg as msgs
import rclpy
from rclpy.executors import ExternalShutdownException


def send(publisher, numbers):
    publisher.publish(msgs.AmazingQuote(
        id=next(numbers), quote='"Ça ira", they said.', philosopher_name='Les Nœuds'))


def report(logger, message):
    logger.info('id: %d' % message.id)
    logger.info('quote: ' + message.quote)
    logger.info('philosopher_name: ' + message.philosopher_name)


def spin(node):
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


def publish():
    rclpy.init()
    node = rclpy.create_node('amazing_quote_publisher_node')
    publisher = node.create_publisher(msgs.AmazingQuote, 'amazing_quote', 1)
    node.create_timer(0.5, partial(send, publisher, count()))
    spin(node)


def listen():
    rclpy.init()
    node = rclpy.create_node('amazing_quote_subscriber_node')
    node.create_subscription(
        msgs.AmazingQuote, 'amazing_quote', partial(report, node.get_logger()), 10)
    spin(node)

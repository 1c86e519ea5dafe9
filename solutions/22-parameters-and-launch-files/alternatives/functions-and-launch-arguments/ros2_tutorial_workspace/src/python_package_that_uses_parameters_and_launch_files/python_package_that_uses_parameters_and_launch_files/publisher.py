from itertools import count

import package_with_interfaces.msg as msgs
import rclpy
from rclpy.executors import ExternalShutdownException

PARAMETERS = [
    ('quote', 'Use the force, Pikachu!'),
    ('philosopher_name', 'Uncle Ben'),
    ('topic_name', 'amazing_quote'),
    ('period', 0.5),
]


def text(node, name):
    return node.get_parameter(name).get_parameter_value().string_value


def main():
    rclpy.init()
    node = rclpy.create_node('amazing_quote_configurable_publisher_node')
    node.declare_parameters('', PARAMETERS)
    topic, period = node.get_parameters(['topic_name', 'period'])
    publisher = node.create_publisher(msgs.AmazingQuote, topic.value, 1)
    numbers = count()

    def say():
        publisher.publish(msgs.AmazingQuote(
            id=next(numbers), quote=text(node, 'quote'),
            philosopher_name=text(node, 'philosopher_name')))

    node.create_timer(period.value, say)
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()

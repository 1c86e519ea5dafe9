import secrets
import string
from random import triangular

import rclpy
from python_package_with_a_library.sample_python_library import SampleClass as Named
from python_package_with_a_library.sample_python_library import (
    sample_function_for_square_of_sum as square_of_sum,
)
from rclpy.executors import ExternalShutdownException


def random_name():
    return ''.join(secrets.choice(string.ascii_letters) for _ in range(10))


def talk(log):
    a, b = triangular(0, 1), triangular(1, 2)
    log('sample_function_for_square_of_sum(%r,%r) returned %r.' % (a, b, square_of_sum(a, b)))
    log('sample_class_with_random_name.get_name() returned %s.' % Named(random_name()).get_name())


def run():
    rclpy.init()
    node = rclpy.create_node('node_that_uses_the_library')
    node.create_timer(0.5, lambda: talk(node.get_logger().info))
    try:
        while rclpy.ok():
            rclpy.spin_once(node, timeout_sec=1.0)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()

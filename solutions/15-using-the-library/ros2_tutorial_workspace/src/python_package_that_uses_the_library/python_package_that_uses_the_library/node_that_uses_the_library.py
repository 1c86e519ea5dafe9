"""The node node_that_uses_the_library tries out the library twice per second."""

import random
import string

import rclpy
from python_package_with_a_library.sample_python_library import (
    SampleClass,
    sample_function_for_square_of_sum,
)
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

PERIOD = 0.5  # seconds
LETTERS_IN_A_NAME = 10


class NodeThatUsesTheLibrary(Node):
    """Passes random numbers and names to the library, and logs what it returns."""

    def __init__(self):
        super().__init__('node_that_uses_the_library')
        self.timer = self.create_timer(PERIOD, self.timer_callback)

    def timer_callback(self):
        """Use the function, then the class."""
        a = random.uniform(0, 1)
        b = random.uniform(1, 2)
        c = sample_function_for_square_of_sum(a, b)
        self.get_logger().info(f'sample_function_for_square_of_sum({a},{b}) returned {c}.')

        name = ''.join(random.choices(string.ascii_letters, k=LETTERS_IN_A_NAME))
        sample = SampleClass(name)
        self.get_logger().info(
            f'sample_class_with_random_name.get_name() returned {sample.get_name()}.')


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(NodeThatUsesTheLibrary())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

#!/usr/bin/env python3
import random
from string import ascii_lowercase, ascii_uppercase

import python_package_with_a_library.sample_python_library as lib
import rclpy
from rclpy.node import Node


class Tester(Node):
    def __init__(self):
        super().__init__('node_that_uses_the_library')
        for step in ('Node has been started,', 'looks around,', 'waits,', 'thinks,') * 4:
            self.get_logger().info(f'{step} definitely.')
        self._rounds = 0
        self.create_timer(1 / 2, self._compute)
        self.create_timer(1 / 2, self._introduce)

    def _compute(self):
        self._rounds += 1
        a, b = random.random(), 1 + random.random()
        result = lib.sample_function_for_square_of_sum(a=a, b=b)
        self.get_logger().info(f'Round {self._rounds}: {result!r} is the square of {a} plus {b}')

    def _introduce(self):
        letters = random.sample(ascii_lowercase + ascii_uppercase, 10)
        me = lib.SampleClass(name=str().join(letters))
        log = self.get_logger()
        log.info(f'definitely called "{me.get_name()}"')


def main(args=None):
    try:
        rclpy.init(args=args)
        rclpy.spin(Tester())
    except KeyboardInterrupt:
        pass
    except Exception as e:
        print(e)


if __name__ == '__main__':
    main()

import random
import sys
from threading import Lock

import rclpy
from geometry_msgs.msg import Point
from package_with_interfaces.srv import WhatIsThePoint
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node


class Sage(Node):
    def __init__(self, name):
        super().__init__(name)
        self._lock = Lock()
        self._calls = 0
        self.create_service(
            srv_type=WhatIsThePoint, srv_name='/what_is_the_point', callback=self.meditate,
            callback_group=ReentrantCallbackGroup())

    def meditate(self, question, _):
        with self._lock:
            self._calls += 1
            number = self._calls
        self.get_logger().info(f'Question no. {number}: {question.quote.quote!r}')
        x, y = (float(random.randint(1, 10_000)) for _ in range(2))
        z = 42.0 - x - y if 'LIFE' in question.quote.quote.upper() else x * y + 43.0
        return WhatIsThePoint.Response(point=Point(x=x, y=y, z=z))


def main():
    rclpy.init(args=sys.argv)
    executor = MultiThreadedExecutor(num_threads=3)
    executor.add_node(Sage('what_is_the_point_service_server'))
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        sys.exit(130)

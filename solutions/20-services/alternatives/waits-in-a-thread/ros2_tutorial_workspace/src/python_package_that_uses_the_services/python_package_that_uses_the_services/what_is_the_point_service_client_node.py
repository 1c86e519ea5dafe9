from itertools import cycle

import rclpy
from package_with_interfaces.srv import WhatIsThePoint
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node


class PointClient(Node):
    def __init__(self):
        super().__init__('what_is_the_point_service_client')
        self.texts = cycle(['a life', 'a leaf'])
        self.client = self.create_client(
            WhatIsThePoint, 'what_is_the_point', callback_group=MutuallyExclusiveCallbackGroup())
        self.timer = self.create_timer(
            0.5, self.ask, callback_group=MutuallyExclusiveCallbackGroup())

    def ask(self):
        if not self.client.service_is_ready():
            self.get_logger().info('The service is not ready')
            return
        request = WhatIsThePoint.Request()
        request.quote.quote = next(self.texts)
        response = self.client.call(request, timeout_sec=0.4)
        if response is None:
            self.get_logger().error('Nobody answered')
        else:
            point = response.point
            self.get_logger().info('The point: %.2f %.2f %.2f' % (point.x, point.y, point.z))


def main(args=None):
    rclpy.init(args=args)
    executor = MultiThreadedExecutor()
    executor.add_node(PointClient())
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass

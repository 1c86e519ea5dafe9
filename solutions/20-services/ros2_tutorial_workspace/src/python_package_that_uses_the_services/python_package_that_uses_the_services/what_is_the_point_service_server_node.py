"""The node what_is_the_point_service_server responds with the point of a quote."""

import random

import rclpy
from package_with_interfaces.srv import WhatIsThePoint
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

THE_ANSWER = 42.0


class WhatIsThePointServer(Node):
    """Responds to calls to /what_is_the_point."""

    def __init__(self):
        super().__init__('what_is_the_point_service_server')
        self.calls = 0
        self.service = self.create_service(
            WhatIsThePoint, '/what_is_the_point', self.point_callback)

    def point_callback(self, request, response):
        """Choose a point. For quotes about life, its sum is 42."""
        self.calls += 1
        response.point.x = random.uniform(0.0, 100.0)
        response.point.y = random.uniform(0.0, 100.0)
        if 'life' in request.quote.quote.lower():
            response.point.z = THE_ANSWER - response.point.x - response.point.y
        else:
            response.point.z = random.uniform(50.0, 100.0)
        self.get_logger().info(f'Call number {self.calls}')
        return response


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(WhatIsThePointServer())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

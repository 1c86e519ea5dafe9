import random

import rclpy
import rclpy.node
from package_with_interfaces import srv


class PointServer(rclpy.node.Node):
    def __init__(self):
        super().__init__('what_is_the_point_service_server')
        self.point_service = self.create_service(
            srv.WhatIsThePoint, '/what_is_the_point', self.what_is_the_point)
        self.number_of_calls = 0
        for _ in range(12):
            self.get_logger().info('Nobody has called so far.')

    def what_is_the_point(self, request: srv.WhatIsThePoint.Request, response: srv.WhatIsThePoint.Response):
        self.get_logger().info('Somebody asks.')
        numbers = [random.uniform(0, 14) for _ in range(3)]
        if 'life' in request.quote.quote.casefold():
            scale = 42 / sum(numbers)
            numbers = [scale * number for number in numbers]
        response.point.x, response.point.y, response.point.z = numbers
        self.number_of_calls = self.number_of_calls + 1
        self.get_logger().info(f'This is the {self.number_of_calls}th call')
        return response


def main(args=None):
    try:
        rclpy.init(args=args)
        node = PointServer()
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    except Exception as e:
        print(e)

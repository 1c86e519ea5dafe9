import random

import rclpy
import rclpy.node
from package_with_interfaces import srv


class PointClient(rclpy.node.Node):
    def __init__(self):
        super().__init__('what_is_the_point_service_client')
        print('First of all, a client:')
        self.point_client = self.create_client(srv.WhatIsThePoint, '/what_is_the_point')
        while not self.point_client.wait_for_service(timeout_sec=0.5):
            self.get_logger().info('service not available, waiting')
        self.future = None
        self.point_timer = self.create_timer(0.5, self.ask)

    def ask(self):
        if self.future is not None:
            if self.future.done():
                self.get_logger().info(str(self.future.result().point))
            else:
                self.future.cancel()
                self.get_logger().warn('the call took too long and was cancelled')
            self.future = None
        if random.random() < 0.5:
            text, name = 'To live is to publish', 'A topic'
        else:
            text, name = 'Service is the rent of life', 'A server'
        request = srv.WhatIsThePoint.Request()
        request.quote.id = random.randint(0, 1000)
        request.quote.quote = text
        request.quote.philosopher_name = name
        self.future = self.point_client.call_async(request)


def main(args=None):
    try:
        rclpy.init(args=args)
        node = PointClient()
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    except Exception as e:
        print(e)

"""The node what_is_the_point_service_client asks for the point of quotes."""

import random

import rclpy
from package_with_interfaces.srv import WhatIsThePoint
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

PERIOD = 0.5  # seconds
QUOTES = (
    ('Life is what happens between two callbacks.', 'A patient client'),
    ('Whoever asks must be able to wait.', 'The other end of the line'),
)


class WhatIsThePointClient(Node):
    """Calls /what_is_the_point twice per second."""

    def __init__(self):
        super().__init__('what_is_the_point_service_client')
        self.client = self.create_client(WhatIsThePoint, '/what_is_the_point')
        while not self.client.wait_for_service(timeout_sec=1.0):
            self.get_logger().info(f'Waiting for {self.client.srv_name}')
        self.future = None
        self.timer = self.create_timer(PERIOD, self.timer_callback)

    def timer_callback(self):
        """Ask for the point of one quote. Cancel the previous call if it is open."""
        if self.future is not None and not self.future.done():
            self.future.cancel()
            self.get_logger().warning('No answer came in time')
        request = WhatIsThePoint.Request()
        request.quote.quote, request.quote.philosopher_name = random.choice(QUOTES)
        self.future = self.client.call_async(request)
        self.future.add_done_callback(self.answer_callback)

    def answer_callback(self, future):
        """Log the point, unless the call was canceled."""
        response = future.result()
        if response is not None:
            point = response.point
            self.get_logger().info(f'The point is ({point.x}, {point.y}, {point.z})')


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(WhatIsThePointClient())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

"""The node what_is_the_point_service_server responds with the point of a quote."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

# TODO 1: import random, and import WhatIsThePoint from chapter 17's package.


class WhatIsThePointServer(Node):
    """Responds to calls to /what_is_the_point."""

    def __init__(self):
        super().__init__('what_is_the_point_service_server')
        # TODO 2: set a count of calls to 0, and create the service, which calls
        #   point_callback.

    def point_callback(self, request, response):
        """Choose a point. For quotes about life, its sum is 42."""
        # TODO 3: count the call, log the count, fill in response.point, and return
        #   the response.


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(WhatIsThePointServer())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

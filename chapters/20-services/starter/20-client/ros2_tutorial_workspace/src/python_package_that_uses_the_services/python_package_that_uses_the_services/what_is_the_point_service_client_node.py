"""The node what_is_the_point_service_client asks for the point of quotes."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

# TODO 1: import WhatIsThePoint.


class WhatIsThePointClient(Node):
    """Calls /what_is_the_point twice per second."""

    def __init__(self):
        super().__init__('what_is_the_point_service_client')
        # TODO 2: create the client, and wait until its service is there. Log a
        #   message while the node waits.
        # TODO 3: set the future to None, and create a timer of 0.5 seconds that
        #   calls timer_callback.

    def timer_callback(self):
        """Ask for the point of one quote."""
        # TODO 4: if the previous call has no response yet, cancel it. Then make a
        #   request, set its quote, call without waiting, and add
        #   response_callback to the future.

    # TODO 5: write response_callback, which logs x, y, and z.


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(WhatIsThePointClient())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

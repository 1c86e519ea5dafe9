import sys

import rclpy
from package_with_interfaces.msg import AmazingQuote
from package_with_interfaces.srv import WhatIsThePoint
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node


class Seeker(Node):
    def __init__(self, name):
        super().__init__(name)
        group = ReentrantCallbackGroup()
        self._asked = 0
        self._sage = self.create_client(WhatIsThePoint, 'what_is_the_point', callback_group=group)
        self.get_logger().info('waiting')
        self._sage.wait_for_service()
        self.create_timer(0.5, self.seek, callback_group=group)

    async def seek(self):
        self._asked += 1
        text = 'LIFE' if self._asked % 3 else 'Nothing else'
        quote = AmazingQuote(id=self._asked, quote=text, philosopher_name='Seeker')
        answer = await self._sage.call_async(WhatIsThePoint.Request(quote=quote))
        self.get_logger().info(f'{self._asked}: {answer.point}')


def main():
    rclpy.init(args=sys.argv)
    executor = MultiThreadedExecutor(num_threads=2)
    executor.add_node(Seeker('what_is_the_point_service_client'))
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        sys.exit(130)

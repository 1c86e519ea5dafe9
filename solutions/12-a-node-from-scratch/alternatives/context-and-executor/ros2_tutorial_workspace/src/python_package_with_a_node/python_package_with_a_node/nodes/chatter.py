from functools import partial
from itertools import count

from rclpy.node import Node


def announce(logger, numbers):
    logger.info('Printed {} times.'.format(next(numbers)))


class Chatterbox(Node):
    def __init__(self, **kwargs):
        super().__init__(node_name='print_forever', **kwargs)
        self.create_timer(timer_period_sec=0.5, callback=partial(announce, self.get_logger(), count()))

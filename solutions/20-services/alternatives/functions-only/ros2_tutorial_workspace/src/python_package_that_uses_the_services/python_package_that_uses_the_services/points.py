import re
from functools import partial
from itertools import count, cycle
from random import gauss

import package_with_interfaces.srv as srv
import rclpy
from rclpy.executors import ExternalShutdownException


def tell_the_point(logger, numbers, request, response):
    logger.info('%d calls so far' % next(numbers))
    if re.search('life', request.quote.quote, re.IGNORECASE):
        response.point.x = 42.0
    else:
        response.point.x, response.point.y = gauss(0, 1), gauss(0, 1)
    return response


def next_question(node, client, futures, quotes):
    if not client.service_is_ready():
        node.get_logger().warn('nobody knows the point yet')
        return
    request = srv.WhatIsThePoint.Request()
    request.quote.quote = next(quotes)
    futures.append(client.call_async(request))
    futures[-1].add_done_callback(partial(report, node))
    while len(futures) > 3:
        futures.pop(0).cancel()


def report(node, future):
    if future.result():
        for axis in 'xyz':
            node.get_logger().info(f'{axis} = {getattr(future.result().point, axis):.3f}')


def spin(node):
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


def serve():
    rclpy.init()
    node = rclpy.create_node('what_is_the_point_service_server')
    node.create_service(
        srv.WhatIsThePoint, 'what_is_the_point', partial(tell_the_point, node.get_logger(), count(1)))
    spin(node)


def ask():
    rclpy.init()
    node = rclpy.create_node('what_is_the_point_service_client')
    client = node.create_client(srv.WhatIsThePoint, 'what_is_the_point')
    quotes = cycle(['Half of a lifetime', '"Ça ira", they said'])
    node.create_timer(0.5, partial(next_question, node, client, [], quotes))
    spin(node)

"""A node for the listings to find: `python nodes.py publisher|parameters|server`."""

from __future__ import annotations

import sys

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int64
from std_srvs.srv import SetBool


def publisher() -> Node:
    node = Node("amazing_quote_publisher_node")
    topic = node.create_publisher(Int64, "amazing_quote", 10)
    node.create_timer(0.1, lambda: topic.publish(Int64(data=1979)))
    return node


def parameters() -> Node:
    node = Node("amazing_quote_configurable_publisher_node")
    node.declare_parameter("quote", "Use the force, Pikachu!")
    node.declare_parameter("philosopher_name", "Uncle Ben")
    node.declare_parameter("topic_name", "amazing_quote")
    node.declare_parameter("period", 0.5)
    return node


def server() -> Node:
    def answer(request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
        response.success, response.message = request.data, "done"
        return response

    node = Node("what_is_the_point_service_server")
    node.create_service(SetBool, "what_is_the_point", answer)
    return node


def subscriber() -> Node:
    node = Node("amazing_quote_subscriber_node")
    node.create_subscription(Int64, "amazing_quote", lambda message: None, 10)
    return node


if __name__ == "__main__":
    rclpy.init()
    rclpy.spin({made.__name__: made for made in (publisher, parameters, server, subscriber)}[sys.argv[1]]())

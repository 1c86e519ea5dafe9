"""The nodes that the real command had around it: `python nodes.py publisher|parameters|server|...`."""

from __future__ import annotations

import sys
import threading
import time
from typing import Any

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int64

QUOTE, PHILOSOPHER = "Use the force, Pikachu!", "Uncle Ben"
_HEARD = """
        I have received the most amazing of quotes.
        It says
            
               '{quote}'
               
        And was thought by the following genius
            
            -- {philosopher}
            
        This latest quote had the id={number}.
        """  # noqa: W293  as it is logged


def publisher() -> Node:
    """Two quotes a second."""
    from package_with_interfaces.msg import AmazingQuote

    node, numbers = Node("amazing_quote_publisher_node"), iter(range(1 << 30))
    topic = node.create_publisher(AmazingQuote, "/amazing_quote", 10)

    def publish() -> None:
        topic.publish(AmazingQuote(id=next(numbers), quote=QUOTE, philosopher_name=PHILOSOPHER))

    node.create_timer(0.5, publish)
    return node


def subscriber() -> Node:
    from package_with_interfaces.msg import AmazingQuote

    node = Node("amazing_quote_subscriber_node")

    def log(heard: Any) -> None:
        text = _HEARD.format(quote=heard.quote, philosopher=heard.philosopher_name, number=heard.id)
        node.get_logger().info(text)

    node.create_subscription(AmazingQuote, "/amazing_quote", log, 10)
    return node


def server() -> Node:
    from geometry_msgs.msg import Point
    from package_with_interfaces.srv import WhatIsThePoint

    def answer(request: Any, response: Any) -> Any:
        response.point = Point(x=28.5, y=10.25, z=2.5)
        return response

    node = Node("what_is_the_point_service_server")
    node.create_service(WhatIsThePoint, "/what_is_the_point", answer)
    return node


def parameters() -> Node:
    node = Node("amazing_quote_configurable_publisher_node")
    node.declare_parameter("quote", QUOTE)
    node.declare_parameter("philosopher_name", PHILOSOPHER)
    node.declare_parameter("topic_name", "amazing_quote")
    node.declare_parameter("period", 0.5)
    return node


def introspected() -> Node:
    """A service that tells of all that goes on."""
    from rclpy.qos import qos_profile_system_default
    from rclpy.service_introspection import ServiceIntrospectionState
    from std_srvs.srv import SetBool

    def answer(request: Any, response: Any) -> Any:
        response.success = request.data
        return response

    node = Node("introspected")
    service = node.create_service(SetBool, "switch", answer)
    service.configure_introspection(
        node.get_clock(), qos_profile_system_default, ServiceIntrospectionState.CONTENTS
    )
    node.create_service(SetBool, "quiet", answer)
    return node


def fibonacci() -> Node:
    from example_interfaces.action import Fibonacci
    from rclpy.action import ActionServer, CancelResponse, GoalResponse

    node = Node("fibonacci_server")

    def work(goal: Any) -> Any:
        sequence = [0, 1]
        for _ in range(goal.request.order - 1):
            sequence.append(sequence[-2] + sequence[-1])
            goal.publish_feedback(Fibonacci.Feedback(sequence=sequence))
            time.sleep(0.2)  # ROS does not promise that feedback arrives before the result
        goal.succeed()
        return Fibonacci.Result(sequence=sequence)

    def judge(request: Any) -> Any:
        return GoalResponse.ACCEPT if request.order > 0 else GoalResponse.REJECT

    node.server = ActionServer(  # kept with the node
        node, Fibonacci, "fibonacci", work,
        goal_callback=judge, cancel_callback=lambda goal: CancelResponse.ACCEPT,
    )  # fmt: skip
    return node


def managed() -> Node:
    """Has states, and refuses to be cleaned up. There is a hidden one of the same kind."""
    from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn

    class Managed(LifecycleNode):
        def on_cleanup(self, state: Any) -> Any:
            return TransitionCallbackReturn.FAILURE

    node = Managed("managed")
    node.hidden = Managed("_hidden_managed")
    rclpy.get_global_executor().add_node(node.hidden)
    return node


def stamps() -> Node:
    """Headers that are 0.2 s old, ten times a second."""
    from geometry_msgs.msg import PointStamped
    from rclpy.duration import Duration

    node = Node("stamps")
    topic = node.create_publisher(PointStamped, "stamped", 10)

    def publish() -> None:
        message = PointStamped()
        message.header.stamp = (node.get_clock().now() - Duration(seconds=0.2)).to_msg()
        topic.publish(message)

    node.create_timer(0.1, publish)
    return node


def slow_clock() -> Node:
    """Simulation time at a tenth of the usual pace."""
    from rclpy.time import Time
    from rosgraph_msgs.msg import Clock

    node = Node("slow_clock")
    topic = node.create_publisher(Clock, "/clock", 10)
    begin = node.get_clock().now().nanoseconds

    def publish() -> None:
        passed = (node.get_clock().now().nanoseconds - begin) // 10
        topic.publish(Clock(clock=Time(seconds=1, nanoseconds=passed).to_msg()))

    node.create_timer(0.005, publish)
    return node


def fast() -> Node:
    """Five thousand numbers, a thousand a second, from when somebody listens."""
    return _counting(1000.0, 5000)


def brisk() -> Node:
    return _counting(500.0, 1 << 30)


def calm() -> Node:
    return _counting(2.0, 1 << 30)


def _counting(rate: float, count: int) -> Node:
    """A thread publishes when it is due, as a timer of rclpy does not at such a rate."""
    node = Node("counting")
    topic = node.create_publisher(Int64, "counted", 1000)

    def publish() -> None:
        while not topic.get_subscription_count():
            time.sleep(0.01)
        time.sleep(0.5)
        begin = time.perf_counter()
        for number in range(count):
            time.sleep(max(0.0, begin + number / rate - time.perf_counter()))
            topic.publish(Int64(data=number))

    threading.Thread(target=publish, daemon=True).start()
    return node


def print_forever() -> Node:
    node, numbers = Node("print_forever"), iter(range(1 << 30))
    node.create_timer(0.5, lambda: node.get_logger().info(f"Printed {next(numbers)} times."))
    return node


KINDS = (
    publisher, subscriber, server, parameters, introspected, fibonacci, managed, stamps, slow_clock,
    fast, brisk, calm, print_forever,
)  # fmt: skip

if __name__ == "__main__":
    # As the tutorial's nodes end: what rclpy raises at SIGTERM has no text, and so it is an empty line.
    try:
        rclpy.init()
        rclpy.spin({made.__name__: made for made in KINDS}[sys.argv[1]]())
    except KeyboardInterrupt:
        pass
    except Exception as error:  # noqa: BLE001
        print(error)

"""The side of rclpy: `python peer.py hear|say|serve|...`. Prints a line for what comes."""

from __future__ import annotations

import sys
from typing import Any

import rclpy
from rcl_interfaces.msg import Log, ParameterEvent
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rosgraph_msgs.msg import Clock
from std_msgs.msg import String
from std_srvs.srv import SetBool


def say(text: object) -> None:
    print(text, flush=True)


def hear(node: Node, topic: str, durability: str = "volatile") -> None:
    qos = QoSProfile(depth=100, durability=DurabilityPolicy[durability.upper()])
    node.create_subscription(String, topic, lambda message: say(message.data), qos)
    say("listening")


def talk(node: Node, topic: str, text: str) -> None:
    publisher = node.create_publisher(String, topic, 10)
    node.create_timer(0.01, lambda: publisher.publish(String(data=text)))


def serve(node: Node) -> None:
    def answer(request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
        response.success, response.message = request.data, "on" if request.data else "off"
        return response

    node.create_service(SetBool, "switch", answer)


def call(node: Node, *names: str) -> None:
    for name in names:
        client = node.create_client(SetBool, name)
        client.wait_for_service()
        future = client.call_async(SetBool.Request(data=True))
        rclpy.spin_until_future_complete(node, future)
        say(f"{name} {future.result().success} {future.result().message}")


def events(node: Node) -> None:
    def show(event: ParameterEvent) -> None:
        for kind in ("new", "changed", "deleted"):
            for parameter in getattr(event, f"{kind}_parameters"):
                say(f"{kind} {event.node} {parameter.name} {parameter.value.double_value}")

    node.create_subscription(ParameterEvent, "/parameter_events", show, 100)
    say("listening")


def clock(node: Node) -> None:
    publisher = node.create_publisher(Clock, "/clock", 1)
    time = Clock()
    time.clock.sec, time.clock.nanosec = 42, 500_000_000
    node.create_timer(0.01, lambda: publisher.publish(time))


def log(node: Node) -> None:
    logger = node.get_logger()
    logger.info("info two 2.0")
    logger.error("error 100%")


def rosout(node: Node) -> None:
    def show(message: Any) -> None:
        say(f"{message.level} {message.name} {message.msg} {message.function} {message.line > 0}")

    kept = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    node.create_subscription(Log, "/rosout", show, kept)
    say("listening")


def main() -> None:
    what, *words = sys.argv[1:]
    rclpy.init(args=[])
    node = Node("logger" if what == "log" else "peer")
    {
        "hear": hear, "say": talk, "serve": serve, "call": call, "events": events, "clock": clock,
        "log": log, "rosout": rosout,
    }[what](node, *words)  # fmt: skip
    if what != "log":
        rclpy.spin(node)


if __name__ == "__main__":
    main()

"""The side of rclpy: `python peer.py hear|say|serve|...`. Prints a line for what comes."""

from __future__ import annotations

import sys
from time import sleep
from typing import Any

import rclpy
from example_interfaces.action import Fibonacci
from rcl_interfaces.msg import Log, ParameterEvent
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.task import Future
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


def act(node: Node) -> None:
    def work(goal: Any) -> Any:
        feedback = Fibonacci.Feedback(sequence=[4, 2])
        while goal.request.order < 0 and not goal.is_cancel_requested:
            goal.publish_feedback(feedback)
            sleep(0.01)
        (goal.canceled if goal.is_cancel_requested else goal.succeed)()
        return Fibonacci.Result(sequence=[goal.request.order])

    node.server = ActionServer(  # kept with the node
        node, Fibonacci, "fibonacci", work,
        goal_callback=lambda goal: GoalResponse.REJECT if goal.order > 100 else GoalResponse.ACCEPT,
        cancel_callback=lambda goal: CancelResponse.ACCEPT, callback_group=ReentrantCallbackGroup(),
    )  # fmt: skip


def ask(node: Node, *orders: str) -> None:
    """Send a goal of each order; those below zero are canceled at the first feedback."""
    client = ActionClient(node, Fibonacci, "fibonacci")
    client.wait_for_server()
    for order in orders:
        fed: Future[Any] = Future()
        sent = client.send_goal_async(Fibonacci.Goal(order=int(order)), feedback_callback=fed.set_result)
        goal = finished(node, sent)
        if not goal.accepted:
            say(f"{order} rejected")
            continue
        if int(order) < 0:
            said = finished(node, fed).feedback.sequence.tolist()
            canceled = finished(node, goal.cancel_goal_async())
            say(f"{order} {said} canceling {len(canceled.goals_canceling)}")
        result = finished(node, goal.get_result_async())
        say(f"{order} {result.status} {result.result.sequence.tolist()}")


def finished(node: Node, future: Future[Any]) -> Any:
    rclpy.spin_until_future_complete(node, future)
    return future.result()


def main() -> None:
    what, *words = sys.argv[1:]
    rclpy.init(args=[])
    node = Node("logger" if what == "log" else "peer")
    {
        "hear": hear, "say": talk, "serve": serve, "call": call, "events": events, "clock": clock,
        "log": log, "rosout": rosout,
        "act": act, "ask": ask,
    }[what](node, *words)  # fmt: skip
    if what != "log":
        rclpy.spin(node, MultiThreadedExecutor() if what == "act" else None)


if __name__ == "__main__":
    main()

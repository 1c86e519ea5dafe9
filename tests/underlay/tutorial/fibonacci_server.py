"""An action server for the tests to talk to: `python3 fibonacci_server.py`."""

import time

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class Server(Node):
    def __init__(self):
        super().__init__("fibonacci_server")
        self.server = ActionServer(self, Fibonacci, "/fibonacci", self.work)

    def work(self, goal):
        sequence = [0, 1]
        while len(sequence) <= goal.request.order:
            sequence.append(sequence[-1] + sequence[-2])
            goal.publish_feedback(Fibonacci.Feedback(sequence=sequence))
            time.sleep(0.05)
        goal.succeed()
        return Fibonacci.Result(sequence=sequence)


try:
    rclpy.init()
    rclpy.spin(Server())
except (KeyboardInterrupt, ExternalShutdownException):
    pass

"""A node, named on the command line, that prints messages on /chatter and passes them on to /heard."""

import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String


class Listener(Node):
    def __init__(self, name):
        super().__init__(name)
        self.publisher = self.create_publisher(String, "/heard", 10)
        self.subscription = self.create_subscription(String, "/chatter", self.hear, 10)

    def hear(self, message):
        print(f"{self.get_name()} heard {message.data}", flush=True)
        self.publisher.publish(message)


def main():
    try:
        rclpy.init()
        node = Listener(sys.argv[1])
        print(f"{sys.argv[1]} ready", flush=True)
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == "__main__":
    main()

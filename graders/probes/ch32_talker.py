"""Publishes the word from its command line and a number on /chatter, ten times per second."""

import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self, word):
        super().__init__("talker")
        self.word = word
        self.number = 0
        self.publisher = self.create_publisher(String, "/chatter", 10)
        self.timer = self.create_timer(0.1, self.say)

    def say(self):
        self.publisher.publish(String(data=f"{self.word} {self.number}"))
        self.number += 1


def main():
    try:
        rclpy.init()
        node = Talker(sys.argv[1])
        print("talker ready", flush=True)
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == "__main__":
    main()

import time

import rclpy
from rclpy.node import Node


class Beacon(Node):
    def __init__(self):
        super().__init__("beacon")
        self.timer = self.create_timer(0.1, self.blink)

    def blink(self):
        print("blink")


rclpy.init()
beacon = Beacon()
time.sleep(1.0)
print("slept")
rclpy.spin_once(beacon)
rclpy.shutdown()

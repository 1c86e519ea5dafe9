import rclpy
from rclpy.node import Node

print("start")
node = Node("warning_light")
rclpy.init()
print(node.get_name())
rclpy.shutdown()

import time

import rclpy
from geometry_msgs.msg import Twist
from rclpy.executors import ExternalShutdownException
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Range


def main():
    """Run the node, with its state in a dict."""
    rclpy.init()
    node = rclpy.create_node('range_sensor')
    state = {'distance': 3.0, 'speed': 0.0, 'at': time.monotonic()}
    publisher = node.create_publisher(Range, 'rover/range', qos_profile_sensor_data)

    def hear(command):
        state['speed'] = command.linear.x

    def measure():
        now = time.monotonic()
        left = state['distance'] - state['speed'] * (now - state['at'])
        state.update(distance=left if left > 0 else 0.0, at=now)
        publisher.publish(Range(
            radiation_type=Range.INFRARED, min_range=0.0, max_range=5.0,
            range=state['distance']))

    node.create_subscription(Twist, 'rover/cmd_vel', hear, qos_profile_sensor_data)
    node.create_timer(1 / 10, measure)
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass

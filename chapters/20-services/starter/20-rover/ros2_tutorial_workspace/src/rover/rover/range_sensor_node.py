"""The node range_sensor publishes the distance to the wall ten times per second."""

import rclpy
from geometry_msgs.msg import Twist
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import Range

PERIOD = 0.1  # seconds


class RangeSensor(Node):
    """Replaces a real sensor: it calculates the distance from the rover's speed."""

    def __init__(self):
        super().__init__('range_sensor')
        self.distance = 3.0
        self.speed = 0.0
        self.publisher = self.create_publisher(Range, '/rover/range', 10)
        self.subscription = self.create_subscription(
            Twist, '/rover/cmd_vel', self.command_callback, 10)
        self.timer = self.create_timer(PERIOD, self.timer_callback)

    def command_callback(self, message):
        """Store the rover's new speed."""
        self.speed = message.linear.x

    def timer_callback(self):
        """Move closer to the wall, and publish the remaining distance."""
        self.distance = max(0.0, self.distance - self.speed * PERIOD)
        message = Range()
        message.range = self.distance
        self.publisher.publish(message)


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(RangeSensor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

"""The node range_sensor tells how far away the wall is, ten times per second."""

import rclpy
from geometry_msgs.msg import Twist
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import Range

PERIOD = 0.1  # seconds


class RangeSensor(Node):
    """Stands for a real sensor: it calculates the distance from the rover's speed."""

    def __init__(self):
        super().__init__('range_sensor')
        self.declare_parameter('distance', 3.0)  # read once, at the start
        self.distance = self.get_parameter('distance').value
        self.speed = 0.0
        self.publisher = self.create_publisher(Range, '/rover/range', 10)
        self.subscription = self.create_subscription(
            Twist, '/rover/cmd_vel', self.command_callback, 10)
        self.timer = self.create_timer(PERIOD, self.timer_callback)

    def command_callback(self, message):
        """Remember how fast the rover drives from now on."""
        self.speed = message.linear.x

    def timer_callback(self):
        """Come closer to the wall, and publish the distance that is left."""
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

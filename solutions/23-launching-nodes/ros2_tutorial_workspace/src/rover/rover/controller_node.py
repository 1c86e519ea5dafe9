"""The node controller drives the rover toward the wall and stops in front of it."""

import rclpy
from geometry_msgs.msg import Twist
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import Range
from std_srvs.srv import SetBool

from rover.driving import safe_speed


class Controller(Node):
    """Listens to the sensor and commands the speed that the library calculates."""

    def __init__(self):
        super().__init__('controller')
        self.declare_parameter('stop_at', 0.5)
        self.declare_parameter('full_speed', 0.5)
        self.stopped = False
        self.publisher = self.create_publisher(Twist, '/rover/cmd_vel', 10)
        self.subscription = self.create_subscription(
            Range, '/rover/range', self.range_callback, 10)
        self.service = self.create_service(SetBool, '/rover/stop', self.stop_callback)

    def range_callback(self, message):
        """Publish a speed for each measurement."""
        command = Twist()
        if not self.stopped:
            stop_at = self.get_parameter('stop_at').value
            full_speed = self.get_parameter('full_speed').value
            command.linear.x = safe_speed(message.range, stop_at, full_speed)
        self.publisher.publish(command)

    def stop_callback(self, request, response):
        """Stop the rover, or let it drive again."""
        self.stopped = request.data
        response.success = True
        response.message = 'Stopped' if self.stopped else 'Driving'
        return response


def main(args=None):
    """Run the node until Ctrl+C."""
    try:
        rclpy.init(args=args)
        rclpy.spin(Controller())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()

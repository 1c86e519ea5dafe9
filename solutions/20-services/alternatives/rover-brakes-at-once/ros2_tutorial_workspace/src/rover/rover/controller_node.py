import rclpy
import rover.driving
from geometry_msgs.msg import Twist, Vector3
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import Range
from std_srvs.srv import SetBool


class Driver(Node):
    """Stops without a flag: it swaps the function that decides."""

    def __init__(self):
        super().__init__('controller')
        self.decide = rover.driving.safe_speed
        self.commands = self.create_publisher(Twist, 'rover/cmd_vel', 1)
        self.create_subscription(Range, 'rover/range', self.measured, 1)
        self.create_service(SetBool, 'rover/stop', self.told)

    def command(self, speed):
        """Publish one command."""
        self.commands.publish(Twist(linear=Vector3(x=float(speed))))

    def measured(self, measurement):
        """Publish a speed for one measurement."""
        speed = self.decide(measurement.range)
        self.get_logger().info(f'{measurement.range:.2f} m: {speed:.2f} m/s')
        self.command(speed)

    def told(self, request, response):
        """Stop at once, or drive again."""
        self.decide = (lambda distance: 0) if request.data else rover.driving.safe_speed
        if request.data:
            self.command(0)
        response.success = True
        return response


def main():
    """Run the node until Ctrl+C."""
    rclpy.init()
    try:
        rclpy.spin(Driver())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
